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

}  // namespace
}  // namespace foramen
