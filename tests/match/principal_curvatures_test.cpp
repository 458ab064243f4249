#include "match/principal_curvatures.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "support/lopsided_torus.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using testing::torus_soup;

VertexMap<PrincipalCurvatures> curvatures_of(const Mesh& mesh, double radius_mm) {
  return principal_curvatures(mesh, vertex_normals(mesh), radius_mm);
}

// A torus round the z axis has the curvature 1 / r along its tube, and cos t / (R + r cos t) across, where
// t is the angle in the tube from its outermost circle.
TEST(PrincipalCurvatures, OfATorusAreThoseOfTheFormula) {
  const double major = 20, minor = 8;
  const Mesh torus = build_mesh(torus_soup(160, 80, major, minor));
  const auto found = curvatures_of(torus, 2.5);
  for (VertexId v : torus.vertices()) {
    const Vec3& p = torus.position(v);
    const double from_axis = std::hypot(p.x(), p.y()), across = (from_axis - major) / minor / from_axis;
    EXPECT_NEAR(found[v].largest, std::max(1 / minor, across), 0.01);
    EXPECT_NEAR(found[v].smallest, std::min(1 / minor, across), 0.01);
  }
}

TEST(PrincipalCurvatures, ChangeTheirSignsIfTheSurfaceIsTurnedInsideOut) {
  const Mesh torus = build_mesh(testing::knobbly_torus_soup(60, 30));
  const auto out = curvatures_of(torus, 3), in = curvatures_of(reversed(torus), 3);
  for (VertexId v : torus.vertices()) {
    EXPECT_NEAR(out[v].largest, -in[v].smallest, 1e-9);
    EXPECT_NEAR(out[v].smallest, -in[v].largest, 1e-9);
  }
}

TEST(PrincipalCurvatures, MoveWithTheSurface) {
  const Mesh torus = build_mesh(testing::knobbly_torus_soup(60, 30));
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Vec3(2, -1, 1).normalized())).pretranslate(Vec3(30, 40, -90));
  const auto before = curvatures_of(torus, 3), after = curvatures_of(transformed(torus, motion), 3);
  for (VertexId v : torus.vertices()) {
    EXPECT_NEAR(before[v].largest, after[v].largest, 1e-9);
    EXPECT_NEAR(before[v].smallest, after[v].smallest, 1e-9);
  }
}

// Two sheets nearer to each other than the radius, as the two sides of a thin wall: each is curved by
// itself.
TEST(PrincipalCurvatures, DoNotSeeTheOtherSideOfAThinWall) {
  const Mesh thick = build_mesh(torus_soup(160, 80, 20, 8));
  std::vector<Vec3> flat(thick.positions().begin(), thick.positions().end());
  for (Vec3& p : flat) p.z() *= 0.05;  // a washer, 0.8 mm thick
  const Mesh washer = thick.with_positions(std::move(flat));
  const auto found = curvatures_of(washer, 2.5);
  for (VertexId v : washer.vertices()) {
    const Vec3& p = washer.position(v);
    if (std::abs(std::hypot(p.x(), p.y()) - 20) > 4) continue;  // away from its edges
    EXPECT_LT(std::abs(found[v].largest) + std::abs(found[v].smallest), 0.05);
  }
}

TEST(PrincipalCurvatures, AreZeroWhereTooFewVerticesAreNear) {
  const Mesh torus = build_mesh(torus_soup(12, 6));
  const auto found = curvatures_of(torus, 0.5);
  for (const PrincipalCurvatures& k : found.values()) {
    EXPECT_EQ(k.largest, 0);
    EXPECT_EQ(k.smallest, 0);
  }
}

TEST(Curvedness, IsThatOfTheStrongerCurvatureWhateverItsSign) {
  EXPECT_EQ(curvedness({0, 0}), 0);
  EXPECT_DOUBLE_EQ(curvedness({0.3, -0.1}), std::tanh(1));
  EXPECT_DOUBLE_EQ(curvedness({0.1, -0.3}), std::tanh(1));
  EXPECT_LT(curvedness({2, 2}), 1);
}

}  // namespace
}  // namespace foramen
