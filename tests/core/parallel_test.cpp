#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

TEST(ParallelFor, CallsEveryItemOnce) {
  for (const int threads : {1, 2, 8})
    for (const int count : {0, 1, 2, 1000}) {
      SCOPED_TRACE(std::to_string(count) + " items on " + std::to_string(threads) + " threads");
      std::vector<std::atomic<int>> calls(count);
      parallel_for(count, RunContext(threads), [&](int i) { ++calls.at(i); });
      for (const auto& c : calls) EXPECT_EQ(c, 1);
    }
}

TEST(ParallelFor, RunsNoMoreItemsAtOnceThanThereAreThreads) {
  for (const int threads : {1, 2}) {
    std::atomic<int> running{0}, most{0};
    parallel_for(40, RunContext(threads), [&](int) {
      const int now = ++running;
      int seen = most;
      while (now > seen && !most.compare_exchange_weak(seen, now)) {
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      --running;
    });
    EXPECT_GE(most, 1);
    EXPECT_LE(most, threads);
  }
}

TEST(ParallelFor, OneThreadGoesInOrderAndEndsAtTheFirstError) {
  std::vector<int> ran;
  try {
    parallel_for(10, RunContext(1), [&](int i) {
      ran.push_back(i);
      if (i >= 3) throw InvalidInput(std::to_string(i));
    });
    FAIL() << "no error";
  } catch (const InvalidInput& e) {
    EXPECT_STREQ(e.what(), "3");
  }
  EXPECT_EQ(ran, (std::vector<int>{0, 1, 2, 3}));
}

// Timing decides which items run after the first error, but not which error is rethrown.
TEST(ParallelFor, OfSeveralErrorsTheSmallestIndexThatRanIsThrownOn) {
  for (int repetition = 0; repetition < 50; ++repetition) {
    std::mutex mutex;
    int smallest = 1000;
    try {
      parallel_for(100, RunContext(4), [&](int i) {
        if (i % 7 != 3) return;
        {
          const std::lock_guard lock(mutex);
          smallest = std::min(smallest, i);
        }
        throw InvalidInput(std::to_string(i));
      });
      FAIL() << "no error";
    } catch (const InvalidInput& e) {
      EXPECT_EQ(e.what(), std::to_string(smallest));
    }
  }
}

TEST(ParallelFor, WhatIsNoExceptionOfOursIsThrownOnToo) {
  for (const int threads : {1, 2})
    EXPECT_THROW(parallel_for(8, RunContext(threads), [](int) { throw 7; }), int);
}

TEST(ParallelFor, AStopRequestEndsItBetweenItems) {
  const RunContext before(2);
  before.request_stop();
  std::atomic<int> ran{0};
  EXPECT_THROW(parallel_for(100, before, [&](int) { ++ran; }), Cancelled);
  EXPECT_EQ(ran, 0);
  const RunContext during(1);
  EXPECT_THROW(parallel_for(100, during,
                            [&](int i) {
                              ++ran;
                              if (i == 10) during.request_stop();
                            }),
               Cancelled);
  EXPECT_EQ(ran, 11) << "item 10 is finished, item 11 not begun";
}

TEST(ParallelFor, LoopsMayBeNested) {
  const RunContext ctx(2);
  std::vector<int> sums(20, 0);
  parallel_for(20, ctx, [&](int i) {
    std::vector<int> parts(10, 0);
    parallel_for(10, ctx, [&](int k) { parts[k] = i * k; });
    for (const int part : parts) sums[i] += part;
  });
  for (int i = 0; i < 20; ++i) EXPECT_EQ(sums[i], 45 * i);
}

}  // namespace
}  // namespace foramen
