#include "foramen/core/rng.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/parallel.hpp"
#include "foramen/core/units.hpp"

namespace foramen {
namespace {

TEST(Rng, SameSeedSameStreamAndForksDoNotDependOnOrder) {
  Rng a(7), b(7);
  a.bits();
  EXPECT_EQ(a.fork(3).bits(), b.fork(3).bits());
  EXPECT_NE(b.fork(3).bits(), b.fork(4).bits());
}

TEST(Rng, NormalHasMeanZeroAndVarianceOne) {
  Rng rng(1);
  const int n = 200000;
  double sum = 0, squares = 0;
  for (int i = 0; i < n; ++i) {
    const double x = rng.normal();
    sum += x;
    squares += x * x;
  }
  EXPECT_NEAR(sum / n, 0, 5 / std::sqrt(n));
  EXPECT_NEAR(squares / n, 1, 5 * std::sqrt(2.0 / n));
}

TEST(Rng, BelowReachesEveryValueAndNoOther) {
  Rng rng(2);
  std::vector<int> seen(5, 0);
  for (int i = 0; i < 1000; ++i) ++seen.at(static_cast<std::size_t>(rng.below(5)));
  for (int count : seen) EXPECT_GT(count, 100);
}

TEST(ParallelFor, GivesTheErrorOfAnItemAndStopsOnRequest) {
  for (int threads : {1, 2, 4}) {
    const RunContext ctx(threads);
    std::vector<int> done(100, 0);
    parallel_for(100, ctx, [&](int i) { done[static_cast<std::size_t>(i)] = i; });
    for (int i = 0; i < 100; ++i) EXPECT_EQ(done[static_cast<std::size_t>(i)], i);
    EXPECT_THROW(parallel_for(100, ctx,
                              [](int i) {
                                if (i == 50) throw InvalidInput("50");
                              }),
                 InvalidInput);
    ctx.request_stop();
    EXPECT_THROW(parallel_for(100, ctx, [](int) {}), Cancelled);
  }
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

TEST(Units, LikelyUnitOfAVertebra) {
  EXPECT_EQ(likely_unit(100), std::nullopt);
  EXPECT_EQ(likely_unit(0.1), LengthUnit::metre);
  EXPECT_EQ(likely_unit(9), LengthUnit::centimetre);
  EXPECT_EQ(likely_unit(90000), LengthUnit::micrometre);
  EXPECT_EQ(likely_unit(1e9), std::nullopt);
}

}  // namespace
}  // namespace foramen
