#pragma once
/// \file
/// Progress of a parallel loop.

#include <atomic>
#include <string>

#include "foramen/core/run_context.hpp"

namespace foramen::detail {

/// Counts the finished items of a stage and reports them. May be called from many threads at once.
class StageProgress {
 public:
  StageProgress(const RunContext& ctx, std::string stage, int items)
      : ctx_(ctx), stage_(std::move(stage)), items_(items) {}
  void finished_one() {
    const int finished = ++finished_;
    ctx_.step(stage_, static_cast<double>(finished) / items_,
              std::to_string(finished) + " of " + std::to_string(items_));
  }

 private:
  const RunContext& ctx_;
  std::string stage_;
  int items_;
  std::atomic<int> finished_{0};
};

}  // namespace foramen::detail
