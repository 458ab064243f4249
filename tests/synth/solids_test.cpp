#include "synth/solids.hpp"

#include <gtest/gtest.h>

#include "foramen/core/rng.hpp"

namespace foramen::synth {
namespace {

Vec3 random_point(Rng& rng, double reach) {
  Vec3 p;
  for (int k = 0; k < 3; ++k) p[k] = rng.uniform(-reach, reach);
  return p;
}

Mat3 some_axes() { return frame(Vec3(1, 0.3, -0.2), Vec3(0, 1, 0.5)); }

template <class Solid>
void expect_gradient_of_differences(const Solid& solid) {
  Rng rng(3);
  constexpr double h = 1e-5;
  int off = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3 p = random_point(rng, 12);
    Vec3 difference;
    for (int k = 0; k < 3; ++k)
      difference[k] =
          (solid.distance(p + h * Vec3::Unit(k)).value - solid.distance(p - h * Vec3::Unit(k)).value) /
          (2 * h);
    off += (difference - solid.distance(p).gradient).norm() > 1e-4 ? 1 : 0;
  }
  EXPECT_LE(off, 1);  // a point may fall on the medial axis, where there is no gradient
}

TEST(Solids, GradientsAgreeWithDifferences) {
  expect_gradient_of_differences(Plate{{1, 2, -1}, some_axes(), {7, 5, 3}, 4, 2});
  expect_gradient_of_differences(Capsule{{-3, 1, 0}, {4, 2, 1}, 3, 1.5});
}

TEST(Solids, APlateHasItsOuterSizes) {
  const Plate plate{Vec3::Zero(), Mat3::Identity(), {7, 5, 3}, 4, 2};
  for (int k = 0; k < 3; ++k) {
    EXPECT_NEAR(plate.distance(plate.half[k] * Vec3::Unit(k)).value, 0, 1e-14);
    EXPECT_NEAR(plate.distance((plate.half[k] + 2.5) * Vec3::Unit(k)).value, 2.5, 1e-14);
  }
  // A corner of the outline is a quarter circle of radius 4 about (3, 1).
  EXPECT_NEAR(plate.distance(Vec3(3, 1, 0) + 4 * Vec3(0.6, 0.8, 0)).value, 0, 1e-14);
}

TEST(Solids, ACapsuleHasItsRadiiAtTheEnds) {
  const Capsule rod{{0, 0, 0}, {10, 0, 0}, 3, 1};
  EXPECT_NEAR(rod.distance({0, 3, 0}).value, 0, 1e-14);
  EXPECT_NEAR(rod.distance({10, 0, 1}).value, 0, 1e-14);
  EXPECT_NEAR(rod.distance({5, 2, 0}).value, 0, 1e-14);
  EXPECT_NEAR(rod.distance({12, 0, 0}).value, 1, 1e-14);
}

TEST(Solids, TheBallHoldsTheSolid) {
  const Plate plate{{1, 2, -1}, some_axes(), {7, 5, 3}, 4, 2};
  const Capsule rod{{-3, 1, 0}, {4, 2, 1}, 3, 1.5};
  Rng rng(5);
  for (int i = 0; i < 1000; ++i) {
    const Vec3 p = random_point(rng, 20);
    EXPECT_GE(plate.distance(p).value, (p - plate.ball().centre).norm() - plate.ball().radius - 1e-12);
    EXPECT_GE(rod.distance(p).value, (p - rod.ball().centre).norm() - rod.ball().radius - 1e-12);
  }
}

TEST(SmoothMin, IsTheMinimumOutsideTheBlendAndBelowItWithin) {
  const Jet a{1, Vec3::UnitX()}, near_a{1.5, Vec3::UnitY()}, far_from_a{4, Vec3::UnitY()};
  EXPECT_EQ(smooth_min(a, far_from_a, 3).value, 1);
  EXPECT_EQ(smooth_min(a, far_from_a, 3).gradient, a.gradient);
  EXPECT_LT(smooth_min(a, near_a, 3).value, 1);
  EXPECT_NEAR(smooth_min(a, a, 3).value, 1 - 0.5, 1e-15);  // k / 6 below equal arguments
  EXPECT_EQ(smooth_min(a, near_a, 3).value, smooth_min(near_a, a, 3).value);
  EXPECT_EQ(smooth_max(a, near_a, 3).value, -smooth_min(-a, -near_a, 3).value);
}

}  // namespace
}  // namespace foramen::synth
