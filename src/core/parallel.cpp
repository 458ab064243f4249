#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <mutex>

#ifdef FORAMEN_STD_THREADS
#include <thread>
#include <vector>
#else
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#endif

namespace foramen {
namespace {

// Of all exceptions that were thrown, keeps the one of the smallest index. Items that begin after the first
// exception are skipped.
class FirstError {
 public:
  void run(int index, const std::function<void(int)>& body) {
    if (failed_.load(std::memory_order_relaxed)) return;
    try {
      body(index);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (index < index_) {
        index_ = index;
        error_ = std::current_exception();
      }
      failed_.store(true, std::memory_order_relaxed);
    }
  }
  void rethrow() const {
    if (error_) std::rethrow_exception(error_);
  }

 private:
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  int index_ = std::numeric_limits<int>::max();
  std::exception_ptr error_;
};

}  // namespace

void parallel_for(int count, const RunContext& ctx, const std::function<void(int)>& body) {
  FirstError first_error;
  const std::function<void(int)> checked = [&](int i) {
    ctx.check();
    body(i);
  };
  if (ctx.threads() == 1 || count <= 1) {
    for (int i = 0; i < count; ++i) first_error.run(i, checked);
    first_error.rethrow();
    return;
  }
#ifdef FORAMEN_STD_THREADS  // the library of TBB is not instrumented for the thread sanitizer
  std::atomic<int> next{0};
  std::vector<std::thread> workers;
  for (int t = 0; t < ctx.threads(); ++t)
    workers.emplace_back([&] {
      for (int i = next++; i < count; i = next++) first_error.run(i, checked);
    });
  for (auto& w : workers) w.join();
#else
  // More threads than cores gain nothing, and TBB would warn about them.
  tbb::task_arena arena(std::min(ctx.threads(), tbb::info::default_concurrency()));
  arena.execute([&] { tbb::parallel_for(0, count, [&](int i) { first_error.run(i, checked); }); });
#endif
  first_error.rethrow();
}

}  // namespace foramen
