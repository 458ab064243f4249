#include "correspond/description_objective.hpp"

#include <cmath>

#include <Eigen/Eigenvalues>

#include <gtest/gtest.h>

#include "foramen/core/rng.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/mapped_tori.hpp"

namespace foramen {
namespace {

TEST(DescriptionObjective, IsTheSquaredDistanceToTheAttractorAndItsSlopeThatOfDifferences) {
  const auto torus = testing::wavy_torus(1500);
  const TorusLocator locator(torus.mesh, torus.map);
  std::vector<Vec3> attractor;
  for (const Vec3& p : torus.mesh.positions()) attractor.push_back(1.1 * p + Vec3(0.3, 0, 0));
  const DescriptionObjective objective(torus.mesh, locator, torus.map, attractor);
  Rng rng(1);
  const double step = 1e-7;
  for (int i = 0; i < 100; ++i) {
    const VertexId v(rng.below(torus.mesh.vertex_count()));
    const Vec2 turns(rng.uniform(), rng.uniform()), x = torus.map.lattice * turns;
    const auto at = objective.term(v, x);
    const SurfacePoint place = locator.locate(turns);
    EXPECT_NEAR(at.value,
                (1.1 * position(torus.mesh, place) + Vec3(0.3, 0, 0) - torus.mesh.position(v)).squaredNorm(),
                1e-8);
    // Near an edge, where the gradient jumps, differences are not valid.
    if (place.barycentric.minCoeff() < 1e-3) continue;
    for (int c = 0; c < 2; ++c) {
      const Vec2 d = step * Vec2::Unit(c);
      const double slope = (objective.term(v, x + d).value - objective.term(v, x - d).value) / (2 * step);
      EXPECT_NEAR(at.gradient[c], slope, 1e-5 * (1 + std::abs(slope)));
    }
    EXPECT_GE(Eigen::SelfAdjointEigenSolver<Mat2>(at.hessian).eigenvalues().minCoeff(), 0);
  }
}

}  // namespace
}  // namespace foramen
