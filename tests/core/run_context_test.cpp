#include "foramen/core/run_context.hpp"

#include <atomic>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/memory_store.hpp"

namespace foramen {
namespace {

using Report = std::tuple<std::string, double, std::string>;

TEST(RunContext, HasAtLeastOneThread) {
  EXPECT_GE(RunContext().threads(), 1);
  EXPECT_EQ(RunContext(3).threads(), 3);
  EXPECT_EQ(RunContext(3).with_threads(2).threads(), 2);
  EXPECT_EQ(RunContext(3).with_threads(0).threads(), 1);
}

TEST(RunContext, StepsAreReportedAsTheyAreSaid) {
  std::vector<Report> reports;
  const RunContext ctx(1, [&](const Progress& p) { reports.emplace_back(p.stage, p.fraction, p.item); });
  ctx.step("register", 0.25, "L1");
  ctx.with_threads(2).step("measure", 1);
  EXPECT_EQ(reports, (std::vector<Report>{{"register", 0.25, "L1"}, {"measure", 1.0, ""}}));
}

TEST(RunContext, WithoutProgressStillStops) {
  int reports = 0;
  const RunContext ctx(1, [&](const Progress&) { ++reports; });
  const RunContext silent = ctx.without_progress();
  silent.step("part", 0.5);
  EXPECT_EQ(reports, 0);
  ctx.step("whole", 0.5);
  EXPECT_EQ(reports, 1);
  ctx.request_stop();
  EXPECT_THROW(silent.step("part", 1), Cancelled);
}

TEST(RunContext, AStopRequestReachesAllCopiesAndNoOtherRun) {
  int reports = 0;
  const RunContext ctx(1, [&](const Progress&) { ++reports; }), other(1);
  const RunContext copy = ctx, threaded = ctx.with_threads(4), stored = ctx.with_store(nullptr);
  EXPECT_NO_THROW(copy.check());
  EXPECT_FALSE(ctx.stop_requested());
  threaded.request_stop();
  for (const RunContext& run : {ctx, copy, threaded, stored, ctx.without_progress()}) {
    EXPECT_TRUE(run.stop_requested());
    EXPECT_THROW(run.check(), Cancelled);
    EXPECT_THROW(run.step("stage", 0.5), Cancelled);
  }
  EXPECT_EQ(reports, 0) << "nothing is reported after the request";
  EXPECT_NO_THROW(other.check());
}

TEST(RunContext, TheCallbackIsCalledByOneThreadAtATime) {
  std::atomic<int> inside{0}, overlaps{0}, reports{0};
  const RunContext ctx(4, [&](const Progress&) {
    if (++inside > 1) ++overlaps;
    ++reports;
    std::this_thread::yield();
    --inside;
  });
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&] {
      for (int i = 0; i < 500; ++i) ctx.step("stage", i / 500.0);
    });
  for (std::thread& t : threads) t.join();
  EXPECT_EQ(overlaps, 0);
  EXPECT_GE(reports, 1);
}

TEST(RunContext, AStepWithinTheCallbackIsDropped) {
  int reports = 0;
  const RunContext* self = nullptr;
  const RunContext ctx(1, [&](const Progress&) {
    ++reports;
    self->step("inner", 0);
  });
  self = &ctx;
  ctx.step("outer", 0);
  EXPECT_EQ(reports, 1);
}

TEST(RunContext, ACallbackThatThrowsIsCalledAgain) {
  int reports = 0;
  const RunContext ctx(1, [&](const Progress&) {
    if (++reports == 1) throw std::runtime_error("no terminal");
  });
  EXPECT_THROW(ctx.step("stage", 0), std::runtime_error);
  EXPECT_NO_THROW(ctx.step("stage", 1));
  EXPECT_EQ(reports, 2);
}

TEST(RunContext, KeepsItsStoreWhateverElseIsChanged) {
  const auto store = std::make_shared<testing::MemoryStore>();
  EXPECT_EQ(RunContext(1).store(), nullptr);
  const RunContext ctx = RunContext(1).with_store(store);
  for (const RunContext& run : {ctx, ctx.with_threads(2), ctx.without_progress()})
    EXPECT_EQ(run.store(), store.get());
  EXPECT_EQ(ctx.with_store(nullptr).store(), nullptr);
}

}  // namespace
}  // namespace foramen
