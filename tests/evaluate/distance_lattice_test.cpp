#include "evaluate/distance_lattice.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "support/meshes.hpp"

namespace foramen::detail {
namespace {

// Checks the bounds at random points up to `far` from a torus, and returns how many of 200 there were.
int checked_bounds(double reach, double spacing, double far) {
  const MeasuredSurface middle(build_mesh(testing::torus_soup(8, 6)), 10, 1);
  const std::vector<MeasuredSurface> surfaces(1, middle);
  const DistanceLattice lattice(middle, surfaces, reach, spacing, RunContext(2));
  std::vector<float> bounds(lattice.width());
  Rng rng(5);
  int bounded = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec3 p = far * Vec3(rng.normal(), rng.normal(), rng.normal());
    const double d = std::sqrt(middle.tree().squared_distance(p));
    EXPECT_FALSE(lattice.surely_within(0, p, 0.999 * d));
    if (!lattice.lower_bounds(p, bounds)) continue;
    EXPECT_LE(static_cast<double>(bounds[0]), d);
    ++bounded;
  }
  return bounded;
}

TEST(DistanceLattice, GivesLowerBoundsNearTheMiddle) {
  EXPECT_GT(checked_bounds(10, 2, 15), 50);
  EXPECT_LT(checked_bounds(10, 2, 15), 200) << "some points are beyond the reach";
}

TEST(DistanceLattice, IsCoarserRatherThanLargerThanTheMemory) {
  EXPECT_EQ(checked_bounds(1e5, 0.1, 15), 200);
}

TEST(DistanceLattice, GivesTheSameBoundsInEveryUnit) {
  for (const double unit : {1.0, 1e-3, 1e3}) {
    TriangleSoup soup = testing::torus_soup(8, 6);
    for (Vec3& p : soup.points) p *= unit;
    const MeasuredSurface middle(build_mesh(soup), 10, 1);
    const std::vector<MeasuredSurface> surfaces(1, middle);
    const DistanceLattice lattice(middle, surfaces, 10 * unit, 2 * unit, RunContext(1));
    std::vector<float> bounds(lattice.width());
    const Vec3 p = Vec3(30, 5, 9) * unit;
    ASSERT_TRUE(lattice.lower_bounds(p, bounds));
    const double d = std::sqrt(middle.tree().squared_distance(p));
    EXPECT_LE(static_cast<double>(bounds[0]), d);
    EXPECT_GT(static_cast<double>(bounds[0]), 0.8 * d);
    EXPECT_TRUE(lattice.surely_within(0, p, d + 2 * unit));
  }
}

}  // namespace
}  // namespace foramen::detail
