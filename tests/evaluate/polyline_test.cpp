#include "evaluate/polyline.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foramen::detail {
namespace {

TEST(Polyline, IsResampledByArcLength) {
  const std::vector<Vec3> corner{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, 3, 0}};  // with a repeated point
  const Polyline open(corner, false);
  EXPECT_DOUBLE_EQ(open.length(), 4);
  EXPECT_LT((open.at(0.5) - Vec3(1, 1, 0)).norm(), 1e-15);
  const auto samples = open.resampled(5);
  EXPECT_LT((samples.front() - corner.front()).norm(), 1e-15);
  EXPECT_LT((samples[1] - Vec3(1, 0, 0)).norm(), 1e-15);
  EXPECT_LT((samples.back() - corner.back()).norm(), 1e-15);
}

TEST(Polyline, AClosedOneReturnsToItsStart) {
  const std::vector<Vec3> square{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  const Polyline ring(square, true);
  EXPECT_DOUBLE_EQ(ring.length(), 8);
  EXPECT_LT((ring.resampled(8)[7] - Vec3(0, 1, 0)).norm(), 1e-15);
  EXPECT_DOUBLE_EQ(ring.distance({-1, 1, 0}), 1);  // to the closing segment
  EXPECT_DOUBLE_EQ(Polyline(square, false).distance({-1, 1, 0}), std::numbers::sqrt2);
}

TEST(Polyline, CentroidDoesNotDependOnWhereItsPointsAre) {
  const std::vector<Vec3> uneven{{0, 0, 0}, {0.1, 0, 0}, {0.2, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};
  EXPECT_LT((Polyline(uneven, true).centroid() - Vec3(1, 1, 0)).norm(), 1e-15);
  EXPECT_EQ(Polyline(std::vector<Vec3>(3, Vec3(1, 2, 3)), true).centroid(), Vec3(1, 2, 3));
}

TEST(PolylineDistance, IsMeasuredBothWays) {
  const std::vector<Vec3> shorter{{0, 0, 0}, {1, 0, 0}}, longer{{0, 0, 0}, {3, 0, 0}};
  // Of the samples 0, 1, 2, 3 of the longer chain, two are 1 and 2 from the shorter one.
  const double expected = (0.0 + 3.0 / 4) / 2;
  EXPECT_DOUBLE_EQ(mean_distance({shorter, false}, {longer, false}, 4), expected);
  EXPECT_DOUBLE_EQ(mean_distance({longer, false}, {shorter, false}, 4), expected);
}

}  // namespace
}  // namespace foramen::detail
