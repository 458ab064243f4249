#include "foramen/core/geometry.hpp"

#include <gtest/gtest.h>

#include "support/meshes.hpp"

namespace foramen {
namespace {

using testing::torus_soup;

TEST(Geometry, TorusAreaAndVolumeConvergeToTheClosedForm) {
  const Mesh mesh = build_mesh(torus_soup(400, 160));
  const double pi = std::numbers::pi;
  EXPECT_NEAR(total_area(mesh) / (4 * pi * pi * 20 * 8), 1, 1e-3);
  EXPECT_NEAR(signed_volume(mesh) / (2 * pi * pi * 20 * 64), 1, 1e-3);
}

TEST(Geometry, ReversingFlipsTheVolume) {
  const Mesh mesh = build_mesh(torus_soup(12, 9));
  EXPECT_NEAR(signed_volume(reversed(mesh)), -signed_volume(mesh), 1e-9);
}

TEST(Geometry, VertexAreasSumToTheTotal) {
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(12, 9, 1));
  double sum = 0;
  for (double a : vertex_areas(mesh)) sum += a;
  EXPECT_NEAR(sum, total_area(mesh), 1e-9);
}

TEST(Geometry, NormalsTurnWithTheMesh) {
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(12, 9, 2));
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized())).pretranslate(Vec3(100, -20, 3));
  const auto before = vertex_normals(mesh), after = vertex_normals(transformed(mesh, motion));
  for (VertexId v : mesh.vertices()) EXPECT_NEAR((motion.linear() * before[v] - after[v]).norm(), 0, 1e-12);
}

// A triangle has the weight of its area, so cutting it into pieces changes nothing.
TEST(Geometry, CentroidOfASurfaceIsWeightedByArea) {
  // Two triangles of areas 1/2 and 2, and the larger again in four pieces.
  const std::vector<Vec3> corners{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {10, 0, 0}, {12, 0, 0}, {10, 2, 0}};
  const Vec3 expected = (0.5 * Vec3(1, 1, 0) / 3 + 2 * Vec3(32, 2, 0) / 3) / 2.5;
  const Mesh two = build_mesh({corners, {{0, 1, 2}, {3, 4, 5}}});
  EXPECT_LT((surface_centroid(two) - expected).norm(), 1e-12);
  std::vector<Vec3> more = corners;
  more.insert(more.end(), {{11, 0, 0}, {11, 1, 0}, {10, 1, 0}});
  const Mesh cut = build_mesh({more, {{0, 1, 2}, {3, 6, 8}, {6, 4, 7}, {8, 7, 5}, {6, 7, 8}}});
  EXPECT_LT((surface_centroid(cut) - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace foramen
