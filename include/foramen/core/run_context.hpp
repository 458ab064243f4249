#pragma once
/// \file
/// Progress, cancellation, the number of threads and where finished work is kept, handed down together. None
/// of them changes a result.

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace foramen {

class StageStore;

struct Progress {
  std::string stage;    ///< what is being done, e.g. "register"
  double fraction = 0;  ///< of this stage, 0 .. 1
  std::string item;     ///< what was just finished, e.g. the name of a shape; may be empty
};

/// Copies share the stop request. Safe to use from many threads; the callback is called by one thread at a
/// time.
class RunContext {
 public:
  using Callback = std::function<void(const Progress&)>;
  /// \param threads 0: as many as the machine has.
  explicit RunContext(int threads = 0, Callback on_progress = {});

  int threads() const { return threads_; }
  /// The same run (stop request, progress) with another number of threads.
  RunContext with_threads(int threads) const;
  /// The same run with its finished work kept in a store (see kept()); null: nothing is kept.
  RunContext with_store(std::shared_ptr<StageStore> store) const;
  /// Null: nothing is kept.
  StageStore* store() const { return store_.get(); }
  /// The same run without its callback, for work that is a small part of a stage.
  RunContext without_progress() const;
  /// Asks all work under this context to stop. Async-signal-safe.
  void request_stop() const noexcept { state_->stop.store(true); }
  bool stop_requested() const noexcept { return state_->stop.load(); }
  /// Throws Cancelled after request_stop().
  void check() const;
  /// Reports progress; throws Cancelled after request_stop().
  void step(std::string_view stage, double fraction, std::string_view item = {}) const;

 private:
  struct State {
    std::atomic<bool> stop{false};
    std::atomic_flag reporting = ATOMIC_FLAG_INIT;
    Callback on_progress;
  };
  int threads_;
  bool reports_ = true;
  std::shared_ptr<State> state_;
  std::shared_ptr<StageStore> store_;
};

}  // namespace foramen
