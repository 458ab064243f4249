#include "synth/local_motion.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "synth/random_flow.hpp"
#include "synth/rough_motions.hpp"
#include "synth/solids.hpp"
#include "synth/vertebra_features.hpp"
#include "synth/vertebra_surface.hpp"

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

// The laws of the features mean something only where the features are.
TEST(VertebraFeatures, LieOnTheTemplate) {
  const auto off = [](const Vec3& p) { return std::abs(vertebra_surface(p).value); };
  for (const int side : {1, -1})
    for (const RimPoint& at : endplate_rim(side, 16))
      EXPECT_LT(off(at.position), 3) << side << " " << at.angle;
  for (const Facet& facet : left_facets()) {
    EXPECT_LT(off(facet.centre), 1);
    EXPECT_GT(vertebra_surface(facet.centre).gradient.normalized().dot(facet.normal), 0.9);
  }
  EXPECT_LT(off(spinous_process().tip), 2.5);
  for (const Process& process : left_processes()) {
    EXPECT_LT(off(process.tip), 2.5);
    EXPECT_LT(vertebra_surface(process.base).value, 0);
  }
}

TEST(RoughMotions, KeepSpaceUnfolded) {
  constexpr double h = 1e-4;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Rng rng(seed);
    const LocalMotions motions = rough_motions(rng);
    for (const LocalMotion& motion : motions.all) {
      const Vec3& p = motion.centre;
      const auto q = carried_by_flow(
          std::vector<Vec3>{p, p + h * Vec3::UnitX(), p + h * Vec3::UnitY(), p + h * Vec3::UnitZ()}, motions,
          16);
      const Vec3 x = q[1] - q[0], y = q[2] - q[0], z = q[3] - q[0];
      EXPECT_GT(x.cross(y).dot(z), 0);
    }
  }
}

}  // namespace
}  // namespace foramen::synth
