#include "foramen/core/mesh.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace foramen {
namespace {

TEST(SurfacePoint, UnitCoordinatesAreTheCornersInTheFacesOrder) {
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(8, 6, 2));
  for (const FaceId f : mesh.faces())
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(position(mesh, {f, Vec3::Unit(k)}), mesh.position(mesh.corners(f)[k]));
}

TEST(SurfacePoint, CoordinatesAreWeightsOfTheCorners) {
  const Mesh mesh = build_mesh({{{0, 0, 0}, {4, 0, 0}, {0, 8, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 3, 1}}});
  EXPECT_EQ(position(mesh, {FaceId(0), Vec3(0.25, 0.5, 0.25)}), Vec3(2, 2, 0));
  EXPECT_EQ(position(mesh, {FaceId(1), Vec3(0, 0.5, 0.5)}), Vec3(2, 0, 0.5));
}

// A point of the surface keeps its place relative to the triangles when the mesh moves.
TEST(SurfacePoint, FollowsAnAffineMotionOfTheMesh) {
  Rng rng(1);
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(10, 7, 3));
  Mat3 linear;
  for (double& x : linear.reshaped()) x = rng.normal();
  const Vec3 shift(1, -2, 3);
  std::vector<Vec3> moved;
  for (const Vec3& p : mesh.positions()) moved.push_back(linear * p + shift);
  const Mesh there = mesh.with_positions(std::move(moved));
  for (int i = 0; i < 100; ++i) {
    const double a = rng.uniform(), b = rng.uniform() * (1 - a);
    const SurfacePoint p{FaceId(rng.below(mesh.face_count())), Vec3(a, b, 1 - a - b)};
    EXPECT_LT((position(there, p) - (linear * position(mesh, p) + shift)).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace foramen
