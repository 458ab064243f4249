#pragma once
/// \file
/// The context of a run: progress reports, cancellation, number of threads and the store of finished stages.
/// None of them changes a result.

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace foramen {

class StageStore;

/// A progress report.
struct Progress {
  std::string stage;    ///< name of the running stage, e.g. "register"
  double fraction = 0;  ///< of this stage, 0 .. 1
  std::string item;     ///< the item that was just finished, e.g. the name of a shape; may be empty
};

/// Copies share the stop request and the callback. All members may be called from many threads at once; the
/// callback is called by one thread at a time.
class RunContext {
 public:
  using Callback = std::function<void(const Progress&)>;
  /// \param threads  0: as many as the machine has
  explicit RunContext(int threads = 0, Callback on_progress = {});

  int threads() const { return threads_; }
  /// The same context (stop request, progress, store) with another number of threads.
  RunContext with_threads(int threads) const;
  /// The same context with a store in which finished stages are kept (see kept()); null: nothing is kept.
  RunContext with_store(std::shared_ptr<StageStore> store) const;
  /// The store of finished stages; null if nothing is kept.
  StageStore* store() const { return store_.get(); }
  /// The same context without progress reports, for work that is a small part of a stage.
  RunContext without_progress() const;
  /// Asks all work that uses this context or a copy of it to stop. Async-signal-safe.
  void request_stop() const noexcept { state_->stop.store(true); }
  bool stop_requested() const noexcept { return state_->stop.load(); }
  /// Throws Cancelled after request_stop().
  void check() const;
  /// Reports progress; throws Cancelled after request_stop(). The report is dropped if another thread is
  /// reporting at the same moment.
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
