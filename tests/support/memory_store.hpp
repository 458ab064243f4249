#pragma once
/// \file
/// A store of finished stages in memory, which can stop the run that uses it.

#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "foramen/core/stage_store.hpp"

namespace foramen::testing {

class MemoryStore : public StageStore {
 public:
  /// The same in every store and whatever the order in which threads ask, so that entries can be compared.
  std::string digest(std::string_view bytes) const override {
    return std::to_string(std::hash<std::string_view>()(bytes));
  }
  std::optional<std::string> load(const std::string& key) override {
    const std::lock_guard lock(mutex_);
    const auto found = entries_.find(key);
    if (found == entries_.end()) return std::nullopt;
    ++loads;
    return found->second;
  }
  void keep(const std::string& key, std::string_view bytes) override {
    const std::lock_guard lock(mutex_);
    if (!entries_.emplace(key, bytes).second) ++kept_twice;
    if (stop_ && std::ssize(entries_) >= stop_at_) stop_->request_stop();
  }
  /// Requests the run to stop when the store has this number of entries.
  void stop(const RunContext& run, int at) {
    stop_ = run.with_store(nullptr);  // otherwise run and store would keep each other alive
    stop_at_ = at;
  }
  int size() const { return static_cast<int>(entries_.size()); }
  const std::map<std::string, std::string>& entries() const { return entries_; }
  int loads = 0, kept_twice = 0;

 private:
  std::mutex mutex_;
  std::map<std::string, std::string> entries_;
  std::optional<RunContext> stop_;
  int stop_at_ = 0;
};

}  // namespace foramen::testing
