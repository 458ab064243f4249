#include "foramen/core/run_context.hpp"

#include <algorithm>
#include <thread>
#include <utility>

#include "foramen/core/error.hpp"

namespace foramen {

RunContext::RunContext(int threads, Callback on_progress)
    : threads_(threads > 0 ? threads : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))),
      state_(std::make_shared<State>()) {
  state_->on_progress = std::move(on_progress);
}

RunContext RunContext::with_threads(int threads) const {
  RunContext other = *this;
  other.threads_ = std::max(1, threads);
  return other;
}

RunContext RunContext::with_store(std::shared_ptr<StageStore> store) const {
  RunContext other = *this;
  other.store_ = std::move(store);
  return other;
}

RunContext RunContext::without_progress() const {
  RunContext other = *this;
  other.reports_ = false;
  return other;
}

void RunContext::check() const {
  if (stop_requested()) throw Cancelled();
}

void RunContext::step(std::string_view stage, double fraction, std::string_view item) const {
  check();
  if (!reports_ || !state_->on_progress) return;
  if (state_->reporting.test_and_set()) return;  // another thread is reporting: this report may be dropped
  struct Release {
    std::atomic_flag& flag;
    ~Release() { flag.clear(); }
  } release{state_->reporting};
  state_->on_progress({std::string(stage), fraction, std::string(item)});
}

}  // namespace foramen
