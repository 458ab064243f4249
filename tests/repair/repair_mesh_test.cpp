#include "foramen/repair/repair_mesh.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "repair/mended.hpp"
#include "spatial/self_intersections.hpp"
#include "support/handles.hpp"
#include "support/meshes.hpp"
#include "support/real_meshes.hpp"

namespace foramen {
namespace {

using testing::count;
using testing::expect_only;
using testing::expect_same;
using ::testing::HasSubstr;
using testing::mended;
using testing::real_mesh;
using testing::renumbered;
using testing::torus_soup;

constexpr int around = 40, tube = 20;

TriangleSoup torus() { return torus_soup(around, tube); }

int grid(int i, int j) { return i * tube + j; }

template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const InvalidInput& e) {
    return e.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

// A closed tetrahedron, wound outward.
void add_tetrahedron(TriangleSoup& soup, const Vec3& at, double size, bool outward = true) {
  const int n = static_cast<int>(soup.points.size());
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)})
    soup.points.emplace_back(at + size * p);
  for (std::array<int, 3> t : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
    if (!outward) std::swap(t[1], t[2]);
    soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  }
}

TEST(RepairMesh, ACleanSurfaceComesBackToTheBit) {
  for (std::uint64_t seed : {1, 2, 3}) {
    TriangleSoup soup = testing::bumpy_torus_soup(around, tube, seed);
    while (!self_intersections(TriangleTree(build_mesh(soup))).empty())
      for (std::size_t v = 0; v < soup.points.size(); ++v)
        soup.points[v] = (soup.points[v] + torus().points[v]) / 2;
    const RepairedMesh repaired = mended(soup);
    expect_only(repaired, {});
    expect_same(repaired.mesh, soup);
    EXPECT_EQ(summary(repaired.report), "nothing to mend");
  }
}

TEST(RepairMesh, RealDataCleanVertebraeComeBackToTheBit) {
  FORAMEN_NEEDS_REAL_DATA();
  for (const char* name : {"lumbar/verse005_L1", "lumbar/verse631_L4", "thoracic/verse581_T7"}) {
    const TriangleSoup soup = real_mesh(name).soup();
    const RepairedMesh repaired = mended(soup);
    expect_only(repaired, {});
    expect_same(repaired.mesh, soup);
  }
}

TEST(RepairMesh, TrianglesApartAreJoined) {
  TriangleSoup apart;
  const TriangleSoup whole = torus();
  for (const auto& t : whole.triangles) {
    const int n = static_cast<int>(apart.points.size());
    for (int corner : t) apart.points.push_back(whole.points[corner]);
    apart.triangles.push_back({n, n + 1, n + 2});
  }
  const RepairedMesh repaired = mended(apart);
  EXPECT_EQ(repaired.mesh.vertex_count(), around * tube);
  expect_only(repaired,
              {{RepairKind::duplicate_vertices, static_cast<int>(apart.points.size()) - around * tube}});
  for (std::size_t v = 0; v < apart.points.size(); ++v) {
    const auto now = repaired.from_raw(VertexId(static_cast<int>(v)));
    ASSERT_TRUE(now);
    EXPECT_EQ(repaired.mesh.position(*now), apart.points[v]);
  }
}

TEST(RepairMesh, UnusedVerticesAreDropped) {
  TriangleSoup soup = torus();
  soup.points.insert(soup.points.begin(), Vec3(900, 0, 0));
  for (auto& t : soup.triangles)
    for (int& corner : t) ++corner;
  const RepairedMesh repaired = mended(soup);
  expect_only(repaired, {{RepairKind::unused_vertices, 1}});
  EXPECT_FALSE(repaired.from_raw(VertexId(0)));
  EXPECT_EQ(repaired.from_raw(VertexId(1)), VertexId(0));
  expect_same(repaired.mesh, torus());
}

TEST(RepairMesh, DuplicateTrianglesAreDroppedWhateverTheirWinding) {
  TriangleSoup soup = torus();
  soup.triangles.push_back(soup.triangles[5]);
  soup.triangles.push_back({soup.triangles[9][0], soup.triangles[9][2], soup.triangles[9][1]});
  const RepairedMesh repaired = mended(soup);
  expect_only(repaired, {{RepairKind::duplicate_triangles, 2}});
  expect_same(repaired.mesh, torus());
}

TEST(RepairMesh, ACopyOfTheWholeSurfaceIsOneSurface) {
  TriangleSoup soup = torus();
  const int n = static_cast<int>(soup.points.size());
  for (int v = 0; v < n; ++v) soup.points.push_back(Vec3(soup.points[v]));
  for (const auto& t : torus().triangles) soup.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  const RepairedMesh repaired = mended(soup);
  expect_only(repaired, {{RepairKind::duplicate_vertices, n},
                         {RepairKind::duplicate_triangles, static_cast<int>(torus().triangles.size())}});
}

TEST(RepairMesh, TrianglesWithoutAreaGo) {
  TriangleSoup soup = torus();
  const auto t = soup.triangles[7];
  const Vec3 a = soup.points[t[0]], b = soup.points[t[1]];
  {  // a triangle with a repeated corner; the rest is intact
    TriangleSoup repeated = soup;
    repeated.triangles.push_back({t[0], t[1], t[1]});
    expect_same(mended(repeated).mesh, soup);
    expect_only(mended(repeated), {{RepairKind::zero_area_triangles, 1}});
  }
  const int m = static_cast<int>(soup.points.size());
  soup.triangles[7] = {t[0], m, t[2]};
  soup.triangles.push_back({m, t[1], t[2]});
  soup.triangles.push_back({t[0], t[1], m});  // flat, between the halves and the neighbour
  for (double place : {0.5, 1e-4, 0.0}) {     // a flat triangle; a needle; two vertices in one place
    SCOPED_TRACE(place);
    TriangleSoup flat = soup;
    flat.points.emplace_back(a + place * (b - a));
    ASSERT_GE(inspect_mesh(flat).degenerate_triangles, 1);
    const RepairedMesh repaired = mended(flat);
    EXPECT_EQ(inspect_mesh(repaired.mesh.soup()).degenerate_triangles, 0);
    EXPECT_GE(count(repaired, RepairKind::zero_area_triangles), 1);
    EXPECT_NEAR(signed_volume(repaired.mesh), signed_volume(build_mesh(torus())), 0.3);
  }
}

TEST(RepairMesh, AFlapIsDropped) {
  TriangleSoup soup = torus();
  const int tip = static_cast<int>(soup.points.size());
  soup.points.emplace_back(40, 0, 0);
  soup.triangles.push_back({grid(0, 0), grid(1, 0), tip});
  const RepairedMesh repaired = mended(soup);
  expect_only(repaired, {{RepairKind::flaps, 1}, {RepairKind::non_manifold_edges, 1}});
  expect_same(repaired.mesh, torus());
}

TEST(RepairMesh, AnInnerWallIsDropped) {
  TriangleSoup soup = torus();
  const int middle = static_cast<int>(soup.points.size());
  soup.points.emplace_back(20, 0, 0);
  for (int j = 0; j < tube; ++j) soup.triangles.push_back({grid(0, j), grid(0, (j + 1) % tube), middle});
  const RepairedMesh repaired = mended(soup);
  expect_only(repaired, {{RepairKind::flaps, 1}, {RepairKind::non_manifold_edges, tube}});
  expect_same(repaired.mesh, torus());
}

TEST(RepairMesh, SolidsThatTouchAlongAnEdgeAreParted) {
  TriangleSoup soup = torus();
  const int n = static_cast<int>(soup.points.size());
  soup.points.emplace_back(33, 1, 1);
  soup.points.emplace_back(33, 1, -1);
  const int a = grid(0, 0), b = grid(1, 0);
  for (const auto& t : {std::array{a, n + 1, b}, {a, b, n}, {a, n, n + 1}, {b, n + 1, n}})
    soup.triangles.push_back(t);
  const RepairedMesh repaired = mended(soup);
  expect_only(repaired, {{RepairKind::non_manifold_edges, 1}, {RepairKind::stray_components, 1}});
  expect_same(repaired.mesh, torus());
}

TEST(RepairMesh, PartsOfOneSurfaceThatTouchInAPointOrAlongAnEdgeAreParted) {
  // Opposite sides of the hole are moved to the axis until they meet.
  const auto draw_out = [](int i, const Vec3& to) {
    TriangleSoup soup = torus_soup(around, tube, 20, 14);
    soup.points[grid(i, tube / 2)] = to;
    soup.points[grid(i + around / 2, tube / 2)] = to;
    for (auto& t : soup.triangles)
      for (int& corner : t)
        if (corner == grid(i + around / 2, tube / 2)) corner = grid(i, tube / 2);
    return soup;
  };
  const RepairedMesh point = mended(draw_out(0, Vec3(0, 0, 0)));
  EXPECT_EQ(count(point, RepairKind::non_manifold_vertices), 1);
  EXPECT_GE(count(point, RepairKind::self_intersections), 1);
  EXPECT_LE(point.report.largest_move_mm, 0.5);
  EXPECT_TRUE(self_intersections(TriangleTree(point.mesh)).empty());
  EXPECT_EQ(count(point, RepairKind::unused_vertices), 1);
}

TEST(RepairMesh, PiecesBesideTheSurfaceAndInsideAreDropped) {
  TriangleSoup soup = torus();
  add_tetrahedron(soup, Vec3(50, 0, 0), 3);
  add_tetrahedron(soup, Vec3(20, 0, 0), 2, false);
  add_tetrahedron(soup, Vec3(-20, 0, 0), 2);
  const RepairedMesh repaired = mended(soup);
  expect_only(repaired, {{RepairKind::stray_components, 1}, {RepairKind::inner_shells, 2}});
  EXPECT_EQ(repaired.report.changes[0].positions[0], Vec3(51.5, 1.5, 1.5));
  expect_same(repaired.mesh, torus());
}

TEST(RepairMesh, APieceOfLikeSizeIsRefused) {
  TriangleSoup soup = torus();
  add_tetrahedron(soup, Vec3(50, 0, 0), 30);
  EXPECT_THAT(refusal([&] { repair_mesh(soup); }), HasSubstr("pieces of like size"));
}

TEST(RepairMesh, WindingIsMadeOneAndOutward) {
  TriangleSoup soup = torus();
  for (std::size_t f : {3u, 77u, 78u, 500u}) std::swap(soup.triangles[f][0], soup.triangles[f][1]);
  const RepairedMesh some = mended(soup);
  expect_only(some, {{RepairKind::reversed_triangles, 4}});
  TriangleSoup inward = torus();
  for (auto& t : inward.triangles) std::swap(t[0], t[1]);
  expect_only(mended(inward), {{RepairKind::reversed_triangles, static_cast<int>(inward.triangles.size())}});
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (f % 3 != 0) std::swap(soup.triangles[f][0], soup.triangles[f][1]);
  EXPECT_NEAR(signed_volume(mended(soup).mesh), signed_volume(build_mesh(torus())), 1e-9);
}

TEST(RepairMesh, AMoebiusBandIsRefused) {
  TriangleSoup band;
  constexpr int steps = 24;
  for (int i = 0; i < steps; ++i)
    for (double side : {-6.0, 6.0}) {
      const double u = 2 * std::numbers::pi * i / steps, r = 20 + side * std::cos(u / 2);
      band.points.emplace_back(r * std::cos(u), r * std::sin(u), side * std::sin(u / 2));
    }
  for (int i = 0; i < steps; ++i) {
    const bool last = i + 1 == steps;
    const int a = 2 * i, b = 2 * i + 1, c = last ? 1 : a + 2, d = last ? 0 : b + 2;
    band.triangles.push_back({a, c, b});
    band.triangles.push_back({b, c, d});
  }
  const std::string said = refusal([&] { repair_mesh(band); });
  EXPECT_THAT(said, HasSubstr("Moebius"));
  EXPECT_THAT(said, HasSubstr("near ("));
}

TEST(RepairMesh, SmallHolesAreFilledSmoothly) {
  TriangleSoup soup = torus();
  std::erase_if(soup.triangles, [](const auto& t) {
    return std::find(t.begin(), t.end(), grid(4, 3)) != t.end() ||
           std::find(t.begin(), t.end(), grid(20, 8)) != t.end();
  });
  const RepairedMesh repaired = mended(soup, {.hole_perimeter_mm = 25});
  expect_only(repaired, {{RepairKind::unused_vertices, 2}, {RepairKind::holes, 2}});
  // Flat disks would lose 11 mm^3.
  EXPECT_NEAR(signed_volume(repaired.mesh), signed_volume(build_mesh(torus())), 4);
  EXPECT_TRUE(self_intersections(TriangleTree(repaired.mesh)).empty());
  for (const Vec3& p : repaired.report.changes[1].positions)
    EXPECT_LT(std::min((p - torus().points[grid(4, 3)]).norm(), (p - torus().points[grid(20, 8)]).norm()), 1);
  // New vertices lie near the torus, whose tube has a radius of 8 mm.
  for (VertexId v : repaired.mesh.vertices()) {
    const Vec3 p = repaired.mesh.position(v);
    if (repaired.origin[v].valid()) continue;
    EXPECT_NEAR(std::hypot(p.head<2>().norm() - 20, p.z()), 8, 0.3);
  }
}

TEST(RepairMesh, ALargeHoleIsRefusedWithItsSizeAndPlace) {
  TriangleSoup soup = torus();
  std::erase_if(soup.triangles,
                [&](const auto& t) { return soup.points[t[0]].x() > 24 && soup.points[t[0]].z() > -2; });
  const std::string said = refusal([&] { repair_mesh(soup); });
  EXPECT_THAT(said, HasSubstr("hole of"));
  EXPECT_THAT(said, HasSubstr("20.0 mm"));
  EXPECT_THAT(said, HasSubstr("edge of the scan"));
  mended(soup, {.hole_perimeter_mm = 200});
}

TEST(RepairMesh, SheetsThatRunThroughEachOtherAreParted) {
  // A flat ring 1.6 mm thick whose upper side is dented through the lower one.
  TriangleSoup soup = torus_soup(100, 60);
  for (Vec3& p : soup.points) p.z() *= 0.1;
  const TriangleSoup flat = soup;
  const int up = 10 * 60 + 15;
  soup.points[up].z() -= 1.75;
  ASSERT_FALSE(self_intersections(TriangleTree(build_mesh(soup))).empty());
  const RepairedMesh repaired = mended(soup);
  EXPECT_TRUE(self_intersections(TriangleTree(repaired.mesh)).empty());
  EXPECT_TRUE(repaired.report.remaining_self_intersections.empty());
  EXPECT_GE(count(repaired, RepairKind::self_intersections), 1);
  EXPECT_LE(repaired.report.largest_move_mm, 0.5);
  for (VertexId v : repaired.mesh.vertices()) {
    if ((repaired.mesh.position(v) - flat.points[up]).norm() < 6) continue;
    EXPECT_EQ(repaired.mesh.position(v), soup.points[repaired.origin[v].index]);
  }
}

TEST(RepairMesh, BridgesAndTunnelsAreAmongTheChanges) {
  testing::TorusWithHandles torus_with(120, 60, 0.3);
  torus_with.drill(40, 6);
  torus_with.bridge(10, 16, 14);
  torus_with.shake(0.01, 3);
  const RepairedMesh repaired = mended(torus_with.soup);
  expect_only(repaired, {{RepairKind::bridges, 1}, {RepairKind::tunnels, 1}});
  EXPECT_THAT(summary(repaired.report), HasSubstr("cut a bridge"));
  EXPECT_THAT(summary(repaired.report), HasSubstr("filled a tunnel"));
  EXPECT_EQ(repaired.report.canal.kind, LoopKind::tunnel);
}

TEST(RepairMesh, WhatIsNoSurfaceIsRefusedByName) {
  TriangleSoup soup = torus();
  EXPECT_THAT(refusal([] { repair_mesh({}); }), HasSubstr("no triangles"));
  soup.points[17].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(refusal([&] { repair_mesh(soup); }), HasSubstr("vertex 17"));
  soup.points[17].y() = std::numeric_limits<double>::infinity();
  EXPECT_THAT(refusal([&] { repair_mesh(soup); }), HasSubstr("vertex 17"));
  soup.points[17].y() = 1e7;
  EXPECT_THAT(refusal([&] { repair_mesh(soup); }), HasSubstr("kilometre"));
  soup = torus();
  soup.triangles[3][1] = 99999;
  EXPECT_THAT(refusal([&] { repair_mesh(soup); }), HasSubstr("triangle 3 uses vertex 99999"));
  soup.triangles[3][1] = -1;
  EXPECT_THAT(refusal([&] { repair_mesh(soup); }), HasSubstr("triangle 3 uses vertex -1"));
  EXPECT_THAT(refusal([] {
                repair_mesh({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}});
              }),
              HasSubstr("none of its triangles"));
}

// Every kind of damage at once, at places that do not touch.
TriangleSoup damaged() {
  TriangleSoup soup = torus();
  const auto with_vertex = [](int v) {
    return [v](const std::array<int, 3>& t) { return std::find(t.begin(), t.end(), v) != t.end(); };
  };
  std::erase_if(soup.triangles, with_vertex(grid(30, 5)));
  soup.triangles.push_back(soup.triangles[100]);
  std::swap(soup.triangles[200][0], soup.triangles[200][2]);
  const int tip = static_cast<int>(soup.points.size());
  soup.points.emplace_back(40, 0, 0);
  soup.triangles.push_back({grid(0, 0), grid(1, 0), tip});
  add_tetrahedron(soup, Vec3(50, 0, 0), 3);
  add_tetrahedron(soup, Vec3(-20, 0, 0), 2);
  return soup;
}

TEST(RepairMesh, ManyDefectsAtOnce) {
  const RepairedMesh repaired = mended(damaged());
  expect_only(repaired, {{RepairKind::unused_vertices, 1},
                         {RepairKind::duplicate_triangles, 1},
                         {RepairKind::flaps, 1},
                         {RepairKind::non_manifold_edges, 1},
                         {RepairKind::stray_components, 1},
                         {RepairKind::inner_shells, 1},
                         {RepairKind::reversed_triangles, 1},
                         {RepairKind::holes, 1}});
  const RepairedMesh again = mended(repaired.mesh.soup());
  expect_only(again, {});
  expect_same(again.mesh, repaired.mesh.soup());
}

TEST(RepairMesh, MotionAndRenumberingChangeNoCount) {
  const RepairedMesh here = mended(damaged());
  TriangleSoup moved = renumbered(damaged(), 3);
  const RigidTransform motion = Eigen::Translation3d(100, -200, 31) *
                                Eigen::AngleAxisd(1.1, Vec3(1, 1, 2).normalized()) *
                                RigidTransform::Identity();
  moved.points = transformed(moved.points, motion);
  const RepairedMesh there = mended(moved);
  ASSERT_EQ(here.report.changes.size(), there.report.changes.size());
  for (std::size_t k = 0; k < here.report.changes.size(); ++k) {
    EXPECT_EQ(here.report.changes[k].kind, there.report.changes[k].kind);
    EXPECT_EQ(here.report.changes[k].count(), there.report.changes[k].count());
  }
  EXPECT_NEAR(signed_volume(here.mesh), signed_volume(there.mesh), 1e-6);
}

}  // namespace
}  // namespace foramen
