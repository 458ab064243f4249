#include "foramen/repair/handles.hpp"

#include <cmath>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/handles.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

double polygon(int sides, double radius) { return 2 * sides * radius * std::sin(std::numbers::pi / sides); }

// The shortest loop round the canal is the ring of edges next to the axis, the shortest round the arch a ring
// of the tube: both are regular polygons.
TEST(FindCanal, OfATorusHasTheLengthsOfItsPolygons) {
  for (const auto& [around, tube, major, minor] : {std::tuple{40, 20, 20.0, 8.0}, {24, 12, 15.0, 4.0}}) {
    const Handle canal = find_canal(build_mesh(testing::torus_soup(around, tube, major, minor)));
    EXPECT_EQ(canal.kind, LoopKind::tunnel);
    EXPECT_NEAR(canal.length_mm, polygon(around, major - minor), 1e-9);
    EXPECT_NEAR(canal.across_mm, polygon(tube, minor), 1e-9);
    EXPECT_LT(canal.position.norm(), 1e-9) << "the axis";
  }
}

// The result does not depend on pose and order, also if the loop round the canal is longer than that round
// the arch.
TEST(FindCanal, DoesNotDependOnPoseOrOrder) {
  const TriangleSoup soup = testing::torus_soup(40, 20, 20, 14);
  const RigidTransform motion = Eigen::Translation3d(100, -200, 31) *
                                Eigen::AngleAxisd(1.1, Vec3(1, 1, 2).normalized()) *
                                RigidTransform::Identity();
  TriangleSoup moved = testing::renumbered(soup, 3);
  moved.points = transformed(moved.points, motion);
  const Handle here = find_canal(build_mesh(soup)), there = find_canal(build_mesh(moved));
  EXPECT_EQ(there.kind, LoopKind::tunnel);
  EXPECT_NEAR(here.length_mm, polygon(40, 6), 1e-9);
  EXPECT_NEAR(there.length_mm, here.length_mm, 1e-9);
  EXPECT_NEAR(there.across_mm, here.across_mm, 1e-9);
  EXPECT_LT((there.position - motion * here.position).norm(), 1e-6);
}

TEST(FindHandles, OfATorusAreItsCanalAlone) {
  const Mesh torus = build_mesh(testing::torus_soup(24, 12));
  const SurfaceHandles handles = find_handles(torus, RunContext(1));
  EXPECT_TRUE(handles.extra.empty());
  EXPECT_NEAR(handles.canal.length_mm, find_canal(torus).length_mm, 1e-12);
}

TEST(FindCanal, IsRefusedWhereThereIsNotOne) {
  TriangleSoup open = testing::torus_soup(12, 9);
  open.triangles.pop_back();
  EXPECT_THROW(find_canal(build_mesh(open)), TopologyError);
  const TriangleSoup octahedron{
      {{20, 0, 0}, {-20, 0, 0}, {0, 20, 0}, {0, -20, 0}, {0, 0, 20}, {0, 0, -20}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  EXPECT_THROW(find_canal(build_mesh(octahedron)), TopologyError);
  EXPECT_THROW(find_handles(build_mesh(octahedron), RunContext(1)), TopologyError);
  testing::TorusWithHandles bridged(60, 30);
  bridged.bridge(5, 10, 7);
  EXPECT_THROW(find_canal(build_mesh(bridged.soup)), TopologyError);
}

}  // namespace
}  // namespace foramen
