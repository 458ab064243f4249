#include "foramen/parameterize/torus_map.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "foramen/core/error.hpp"
#include "parameterize/mapped_torus.hpp"

namespace foramen {
namespace {

using testing::mapped_bumpy_torus;

TEST(Certificate, AcceptsGoodMaps) {
  for (const auto& [name, torus] : testing::genus1_maps()) {
    SCOPED_TRACE(name);
    const MapCertificate c = certify(torus.mesh, torus.map);
    EXPECT_TRUE(c.valid());
    EXPECT_EQ(c.triangles, torus.mesh.face_count());
    EXPECT_EQ(c.degree, 1);  // exact
    EXPECT_GT(c.smallest_area_ratio, 0);
    EXPECT_LT(c.smallest_area_ratio, 1);
    EXPECT_GT(c.largest_area_ratio, 1);
    EXPECT_TRUE(certify(torus.mesh, wrapped(torus.mesh, quantised(torus.mesh, torus.map))).valid());
  }
}

TEST(Certificate, CountsFlippedTriangles) {
  auto [mesh, map] = mapped_bumpy_torus(12, 9, 1);
  map.turns[VertexId(17)] += Vec2(0.4, 0.1);
  const MapCertificate c = certify(mesh, map);
  EXPECT_EQ(c.flipped, testing::flipped_triangles(mesh, map));
  EXPECT_GT(c.flipped, 0);
  EXPECT_EQ(c.degree, 1);  // moving a vertex does not change the degree
  EXPECT_FALSE(c.valid());
}

// Three points on a line. In floating-point arithmetic, the sign of the area is lost in rounding; integer
// arithmetic gives exactly zero.
TEST(Certificate, SeesATriangleOfExactlyNoArea) {
  auto [mesh, map] = mapped_bumpy_torus(12, 9, 2);
  map = quantised(mesh, map);
  const FaceId f(40);
  const auto c = mesh.corners(f);
  const Vec2 a = map.turns[c[0]],
             along = map.turns[c[1]] + map.jumps[Mesh::halfedge(f, 0)].cast<double>() - a;
  map.turns[c[2]] = a + 2 * along + map.jumps[Mesh::halfedge(f, 2)].cast<double>();
  const MapCertificate none = certify(mesh, map);
  EXPECT_EQ(none.smallest_area_ratio <= 0, true);
  const int with_flat = none.flipped;
  map.turns[c[2]] += std::ldexp(1.0, -quantum_bits) * Vec2(-along.y(), along.x()).array().sign().matrix();
  EXPECT_EQ(certify(mesh, map).flipped, with_flat - 1);
}

TEST(Certificate, SeesInconsistentPeriods) {
  auto [mesh, map] = mapped_bumpy_torus(12, 9, 3);
  const TorusMap good = map;
  map.jumps[HalfedgeId(5)] += Vec2i(1, 0);
  EXPECT_FALSE(certify(mesh, map).periods_consistent);
  map.jumps[mesh.twin(HalfedgeId(5))] -= Vec2i(1, 0);  // antisymmetric, but not closed
  EXPECT_FALSE(certify(mesh, map).periods_consistent);
  EXPECT_TRUE(certify(mesh, good).periods_consistent);
}

TEST(Certificate, RefusesAReflectedMapAndPositionsThatAreNotNumbers) {
  auto [mesh, map] = mapped_bumpy_torus(12, 9, 4);
  Eigen::Matrix2i swap;
  swap << 0, 1, 1, 0;
  const MapCertificate c = certify(mesh, change_basis(map, swap));
  EXPECT_EQ(c.flipped, mesh.face_count());
  EXPECT_EQ(c.degree, -1);
  map.turns[VertexId(3)].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(certify(mesh, map), InvalidInput);
}

}  // namespace
}  // namespace foramen
