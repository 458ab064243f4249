#pragma once
/// \file
/// A store of finished stages in memory, which can stop the run that uses it.

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "foramen/core/stage_store.hpp"

namespace foramen::testing {

class MemoryStore : public StageStore {
 public:
  /// The digest is the number of this string of bytes in the order of first requests.
  std::string digest(std::string_view bytes) const override {
    const std::lock_guard lock(mutex_);
    return std::to_string(digests_.emplace(bytes, digests_.size()).first->second);
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
  mutable std::mutex mutex_;
  mutable std::map<std::string, std::size_t, std::less<>> digests_;
  std::map<std::string, std::string> entries_;
  std::optional<RunContext> stop_;
  int stop_at_ = 0;
};

}  // namespace foramen::testing
