#include "synth/local_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synth/solids.hpp"

namespace foramen::synth {
namespace {

const Vec3 mirror(-1, 1, 1);

TEST(LocalMotion, IsAffineAtItsCentreAndWindowedAlongItsAxes) {
  const Mat3 axes = frame(Vec3(1, 2, 0), Vec3::UnitZ());
  LocalMotion motion{.centre = {1, 2, 3}, .precision = window_precision(axes, {2, 4, 8})};
  motion.pivot = {0, 0, 3};
  motion.shift = {0.5, 0, 0};
  motion.linear = 2 * Mat3::Identity();
  EXPECT_NEAR((motion(motion.centre) - Vec3(2.5, 4, 0)).norm(), 0, 1e-12);
  const Vec3 aside = motion.centre + 4 * axes.col(1);  // one standard deviation
  EXPECT_NEAR((motion(aside) - std::exp(-0.5) * (motion.shift + 2 * (aside - motion.pivot))).norm(), 0,
              1e-12);
  EXPECT_EQ(motion(motion.centre + 20 * axes.col(0)), Vec3(0, 0, 0));
}

TEST(LocalMotion, TheMirroredMotionMovesTheMirroredPoint) {
  const Mat3 axes = frame(Vec3(1, 2, 0.5), Vec3::UnitZ());
  LocalMotion motion{.centre = {5, 2, 3}, .precision = window_precision(axes, {2, 4, 8})};
  motion.pivot = {1, 0, 3};
  motion.shift = {0.5, 1, -2};
  motion.linear << 1, 2, 3, 4, 5, 6, 7, 8, 10;
  const Vec3 p(6, 1, 4);
  EXPECT_NEAR((mirrored(motion)(mirror.cwiseProduct(p)) - mirror.cwiseProduct(motion(p))).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace foramen::synth
