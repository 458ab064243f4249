#include "correspond/surface_targets.hpp"

#include <gtest/gtest.h>

#include "correspond/template_surface.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "parameterize/mapped_torus.hpp"

namespace foramen {
namespace {

class SurfaceTargetsTest : public ::testing::Test {
 protected:
  const testing::MappedTorus torus = testing::mapped_bumpy_torus(60, 30, 3);
  const TemplateSurface surface{torus.mesh, torus.map};
  const VertexMap<Mat2> tensors = metric_tensors(surface);
  std::vector<Vec3> places() const { return {torus.mesh.positions().begin(), torus.mesh.positions().end()}; }
};

TEST_F(SurfaceTargetsTest, TheTemplateItselfIsAtItsTargets) {
  const SurfaceTargets targets(torus.mesh, surface, tensors, places());
  EXPECT_EQ(targets.share_without(), 0);
  for (VertexId v : torus.mesh.vertices())
    EXPECT_NEAR(targets.term(v, torus.map.lattice * torus.map.turns[v]).value, 0, 1e-12);
}

TEST_F(SurfaceTargetsTest, IsPeriodicAndItsSlopeIsThatOfDifferences) {
  const SurfaceTargets targets(torus.mesh, surface, tensors, places());
  const double step = 1e-6;
  for (int i = 0; i < torus.mesh.vertex_count(); i += 97) {
    const VertexId v(i);
    const Vec2 x = torus.map.lattice * (torus.map.turns[v] + Vec2(0.03, -0.02));
    const auto at = targets.term(v, x);
    EXPECT_NEAR(targets.term(v, x + torus.map.lattice * Vec2(2, -1)).value, at.value, 1e-9);
    for (int c = 0; c < 2; ++c) {
      const Vec2 d = step * Vec2::Unit(c);
      EXPECT_NEAR(at.gradient[c], (targets.term(v, x + d).value - targets.term(v, x - d).value) / (2 * step),
                  1e-4);
      const Vec2 turn = (targets.term(v, x + d).gradient - targets.term(v, x - d).gradient) / (2 * step);
      EXPECT_LT((at.hessian.col(c) - turn).norm(), 1e-3 * at.hessian.norm());
    }
  }
}

TEST_F(SurfaceTargetsTest, WhatIsOutOfReachOrFacesAwayHasNoTarget) {
  std::vector<Vec3> far = places();
  for (Vec3& p : far) p += Vec3(500, 0, 0);
  EXPECT_EQ(SurfaceTargets(torus.mesh, surface, tensors, far).share_without(), 1);
  EXPECT_EQ(SurfaceTargets(reversed(torus.mesh), surface, tensors, places(), {.reach_mm = 1}).share_without(),
            1);
  EXPECT_THROW(SurfaceTargets(torus.mesh, surface, tensors, places(), {.reach_mm = 0}), InvalidInput);
}

}  // namespace
}  // namespace foramen
