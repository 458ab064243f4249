#include "foramen/core/rng.hpp"

#include <gtest/gtest.h>

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
  for (int i = 0; i < 1000; ++i) ++seen.at(rng.below(5));
  for (int count : seen) EXPECT_GT(count, 100);
}

}  // namespace
}  // namespace foramen
