#include "synth/rough_motions.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "synth/random_flow.hpp"

namespace foramen::synth {
namespace {

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
