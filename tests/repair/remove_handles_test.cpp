#include "foramen/repair/handles.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "spatial/self_intersections.hpp"
#include "support/double_torus.hpp"
#include "support/handles.hpp"
#include "support/meshes.hpp"
#include "support/messages.hpp"
#include "support/real_meshes.hpp"

namespace foramen {
namespace {

using testing::offers;
using testing::real_mesh;
using testing::refusal;
using testing::renumbered;
using testing::says;
using testing::torus_soup;
using testing::TorusWithHandles;

int genus(const Mesh& mesh) { return (2 - mesh.euler_characteristic()) / 2; }

// A flat ring 48 mm wide and 4.8 mm thick.
TorusWithHandles flat_ring() { return {120, 60, 0.3}; }

TriangleSoup bridged() {
  TorusWithHandles torus(120, 60);
  torus.bridge(10, 20, 14);
  torus.shake(0.01, 1);
  return torus.soup;
}

TriangleSoup drilled() {
  TorusWithHandles torus = flat_ring();
  torus.drill(40, 6);
  torus.shake(0.01, 2);
  return torus.soup;
}

RigidTransform some_motion() {
  return Eigen::Translation3d(-310, 95, 1200) * Eigen::AngleAxisd(2.3, Vec3(3, -1, 2).normalized()) *
         RigidTransform::Identity();
}

// Faces by the positions of their corners.
std::set<std::array<double, 9>> face_keys(const Mesh& mesh) {
  std::set<std::array<double, 9>> keys;
  for (FaceId f : mesh.faces()) {
    auto t = mesh.triangle(f);
    std::rotate(t.begin(),
                std::min_element(t.begin(), t.end(),
                                 [](const Vec3& a, const Vec3& b) {
                                   return std::lexicographical_compare(a.begin(), a.end(), b.begin(),
                                                                       b.end());
                                 }),
                t.end());
    keys.insert({t[0].x(), t[0].y(), t[0].z(), t[1].x(), t[1].y(), t[1].z(), t[2].x(), t[2].y(), t[2].z()});
  }
  return keys;
}

// Expects that every changed triangle is within this distance of a removed handle, and that all other
// vertices are the same, to the bit and in the same order.
void expect_changed_only_near(const Mesh& before, const HandleRemoval& after, double distance_mm) {
  VertexId last;
  for (VertexId v : after.mesh.vertices()) {
    const VertexId was = after.origin[v];
    if (!was.valid()) continue;
    EXPECT_LT(last, was);
    EXPECT_EQ(after.mesh.position(v), before.position(was));
    last = was;
  }
  const auto old_faces = face_keys(before), new_faces = face_keys(after.mesh);
  const auto is_near = [&](const std::array<double, 9>& face) {
    for (std::size_t k = 0; k < 9; k += 3) {
      const Vec3 corner(face[k], face[k + 1], face[k + 2]);
      if (std::none_of(after.removed.begin(), after.removed.end(),
                       [&](const Handle& h) { return (h.position - corner).norm() <= distance_mm; }))
        return false;
    }
    return true;
  };
  std::vector<std::array<double, 9>> changed;
  std::set_symmetric_difference(old_faces.begin(), old_faces.end(), new_faces.begin(), new_faces.end(),
                                std::back_inserter(changed));
  EXPECT_EQ(changed.empty(), after.removed.empty());
  EXPECT_TRUE(std::all_of(changed.begin(), changed.end(), is_near));
}

void expect_mended(const HandleRemoval& after) {
  EXPECT_EQ(genus(after.mesh), 1);
  EXPECT_TRUE(after.mesh.is_closed());
  EXPECT_TRUE(self_intersections(TriangleTree(after.mesh)).empty());
  EXPECT_GT(signed_volume(after.mesh), 0);
  EXPECT_EQ(after.canal.kind, LoopKind::tunnel);
}

TEST(FindHandles, ABridgeIsGivenByItsGirthAndItsArch) {
  const SurfaceHandles found = find_handles(build_mesh(bridged()), RunContext(2));
  ASSERT_EQ(found.extra.size(), 1u);
  const Handle& bridge = found.extra[0];
  EXPECT_EQ(bridge.kind, LoopKind::handle);
  // The loop round the bridge is a quad of 1.05 by 0.84 mm. The loop along it is a half circle of 9 mm
  // diameter and returns on the torus.
  EXPECT_NEAR(bridge.length_mm, 2 * (0.9 + 0.84), 0.4);
  EXPECT_NEAR(bridge.across_mm, std::numbers::pi / 2 * 9 + 9, 3);
  EXPECT_EQ(found.canal.kind, LoopKind::tunnel);
  EXPECT_NEAR(found.canal.length_mm, 2 * std::numbers::pi * 12, 0.5);
  EXPECT_NEAR(found.canal.across_mm, 2 * std::numbers::pi * 8, 0.5);
}

TEST(FindHandles, ATunnelIsGivenByItsGirthAndTheWayThroughIt) {
  const SurfaceHandles found = find_handles(build_mesh(drilled()), RunContext(2));
  ASSERT_EQ(found.extra.size(), 1u);
  EXPECT_EQ(found.extra[0].kind, LoopKind::tunnel);
  const double angle = 2 * std::numbers::pi * 40.5 / 120;
  EXPECT_LT((found.extra[0].position - 26.3 * Vec3(std::cos(angle), std::sin(angle), 0)).norm(), 2);
}

TEST(RemoveHandles, ABridgeIsCut) {
  const Mesh before = build_mesh(bridged());
  ASSERT_EQ(genus(before), 2);
  const HandleRemoval after = remove_handles(before);
  expect_mended(after);
  ASSERT_EQ(after.removed.size(), 1u);
  EXPECT_EQ(after.removed[0].kind, LoopKind::handle);
  expect_changed_only_near(before, after, 4);
  EXPECT_LT(std::abs(signed_volume(after.mesh) - signed_volume(before)), 5);
}

TEST(RemoveHandles, ATunnelIsFilled) {
  const Mesh before = build_mesh(drilled());
  ASSERT_EQ(genus(before), 2);
  const HandleRemoval after = remove_handles(before);
  expect_mended(after);
  ASSERT_EQ(after.removed.size(), 1u);
  EXPECT_EQ(after.removed[0].kind, LoopKind::tunnel);
  expect_changed_only_near(before, after, 4);
  EXPECT_GT(signed_volume(after.mesh), signed_volume(before));
}

TEST(RemoveHandles, SeveralGoOneByOneTheShortestFirst) {
  TorusWithHandles torus = flat_ring();
  torus.drill(40, 6);
  torus.drill(80, 5);
  torus.bridge(10, 16, 14);
  torus.shake(0.01, 3);
  const Mesh before = build_mesh(torus.soup);
  ASSERT_EQ(genus(before), 4);
  const HandleRemoval after = remove_handles(before);
  expect_mended(after);
  ASSERT_EQ(after.removed.size(), 3u);
  for (std::size_t k = 1; k < 3; ++k) EXPECT_LE(after.removed[k - 1].length_mm, after.removed[k].length_mm);
  expect_changed_only_near(before, after, 4);
}

TEST(RemoveHandles, MotionAndRenumberingChangeNothing) {
  for (const TriangleSoup& soup : {bridged(), drilled()}) {
    const HandleRemoval here = remove_handles(build_mesh(soup));
    TriangleSoup moved = renumbered(soup, 7);
    moved.points = transformed(moved.points, some_motion());
    const HandleRemoval there = remove_handles(build_mesh(moved));
    ASSERT_EQ(there.removed.size(), 1u);
    const Handle &a = here.removed[0], &b = there.removed[0];
    EXPECT_EQ(a.kind, b.kind);
    EXPECT_NEAR(a.length_mm, b.length_mm, 1e-9);
    EXPECT_NEAR(a.across_mm, b.across_mm, 1e-9);
    EXPECT_LT((some_motion() * a.position - b.position).norm(), 1e-9);
    EXPECT_NEAR(here.canal.length_mm, there.canal.length_mm, 1e-9);
    EXPECT_EQ(here.mesh.face_count(), there.mesh.face_count());
    EXPECT_NEAR(signed_volume(here.mesh), signed_volume(there.mesh), 1e-6);
  }
}

TEST(RemoveHandles, AGenus1SurfaceComesBackAsItIs) {
  const Mesh before = build_mesh(torus_soup(40, 20));
  const HandleRemoval after = remove_handles(before);
  EXPECT_TRUE(after.removed.empty());
  EXPECT_EQ(after.mesh.triangles(), before.triangles());
  for (VertexId v : before.vertices()) {
    EXPECT_EQ(after.mesh.position(v), before.position(v));
    EXPECT_EQ(after.origin[v], v);
  }
  EXPECT_NEAR(after.canal.length_mm, 40 * 2 * 12 * std::sin(std::numbers::pi / 40), 1e-9);
}

TEST(RemoveHandles, AHandleThatIsNoNoiseIsAnatomy) {
  TorusWithHandles torus(120, 60);
  torus.drill(40, 15, 20);  // through 16 mm of the solid
  torus.shake(0.01, 2);
  const Mesh mesh = build_mesh(torus.soup);
  const Message said = refusal([&] { remove_handles(mesh); });
  EXPECT_THAT(said, says("genus 2"));
  EXPECT_THAT(said, says("foramina transversaria"));
  EXPECT_THAT(said, says("tunnel"));
  EXPECT_THAT(said, offers({{RemedyKind::handle_limit}}));
  const HandleRemoval after = remove_handles(mesh, {.noise_mm = 60});
  expect_mended(after);
  expect_changed_only_near(mesh, after, 4);
}

TEST(RemoveHandles, TheRuleOfNoise) {
  const RemoveHandlesOptions options;
  EXPECT_TRUE(is_noise({LoopKind::tunnel, 2, 11.9, Vec3::Zero()}, options));
  EXPECT_FALSE(is_noise({LoopKind::tunnel, 2, 12.1, Vec3::Zero()}, options));
  EXPECT_TRUE(is_noise({LoopKind::handle, 3.9, 30, Vec3::Zero()}, options));
  EXPECT_FALSE(is_noise({LoopKind::handle, 4.1, 30, Vec3::Zero()}, options));
}

TEST(RemoveHandles, WithoutAHoleThereIsNoCanal) {
  TriangleSoup octahedron{
      {{9, 0, 0}, {-9, 0, 0}, {0, 9, 0}, {0, -9, 0}, {0, 0, 9}, {0, 0, -9}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  const Message said = refusal([&] { remove_handles(build_mesh(octahedron)); });
  EXPECT_THAT(said, says("genus 0"));
  EXPECT_THAT(said, says("arch is open"));
}

TEST(RemoveHandles, AHoleNoLargerThanNoiseIsNoCanal) {
  EXPECT_THAT(refusal([] { remove_handles(build_mesh(torus_soup(30, 20, 2.4, 0.8))); }),
              says("no larger than noise"));
}

TEST(RemoveHandles, AThinBridgeThatMayCloseTheCanalIsNotCut) {
  TorusWithHandles torus(120, 60);
  for (Vec3& p : torus.soup.points) {  // the hole in the middle is narrowed to a diameter of 12 mm
    const double radius = p.head<2>().norm();
    p.head<2>() *= (radius - 10) / radius;
  }
  torus.bridge(10, 60, 14, 40);
  torus.shake(0.001, 1);
  EXPECT_THAT(refusal([&] { remove_handles(build_mesh(torus.soup)); }),
              says("two holes may be the vertebral canal"));
}

TEST(RemoveHandles, TooManyHandlesAreRefusedWithoutASearch) {
  EXPECT_THAT(refusal([] { remove_handles(build_mesh(bridged()), {.most_handles = 1}); }),
              says("genus 2: more than"));
}

TEST(RemoveHandles, AnOpenSurfaceIsRefused) {
  TriangleSoup open = torus_soup(12, 9);
  open.triangles.pop_back();
  EXPECT_THROW(remove_handles(build_mesh(open)), TopologyError);
}

struct Expected {
  std::string name;
  std::vector<LoopKind> kinds;
};

TEST(RemoveHandles, RealDataDefectiveVertebraeBecomeGenus1) {
  FORAMEN_NEEDS_REAL_DATA();
  const auto bridge = LoopKind::handle, tunnel = LoopKind::tunnel;
  for (const Expected& shape :
       {Expected{"verse005_L3_genus2", {tunnel}}, Expected{"verse581_L4_genus2", {tunnel}},
        Expected{"verse631_T6_genus3", {bridge, bridge}}, Expected{"verse823_T10_genus2", {bridge}},
        Expected{"verse823_T1_genus2", {tunnel}}}) {
    SCOPED_TRACE(shape.name);
    const Mesh before = real_mesh("defective/" + shape.name);
    const HandleRemoval after = remove_handles(before);
    expect_mended(after);
    std::vector<LoopKind> kinds;
    for (const Handle& h : after.removed) {
      kinds.push_back(h.kind);
      EXPECT_LT(h.length_mm, 2.5);
    }
    EXPECT_EQ(kinds, shape.kinds);
    expect_changed_only_near(before, after, 3);
    EXPECT_NEAR(signed_volume(after.mesh), signed_volume(before), 3);
    EXPECT_GT(after.canal.length_mm, 50);
  }
}

TEST(RemoveHandles, RealDataCervicalVertebraeAreRefusedUnlessTheirForaminaAreClosed) {
  FORAMEN_NEEDS_REAL_DATA();
  int refused = 0, as_they_are = 0;
  for (const auto& file : std::filesystem::directory_iterator(testing::data_dir() / "cervical")) {
    const std::string name = file.path().stem().string();
    SCOPED_TRACE(name);
    const Mesh mesh = real_mesh("cervical/" + name);
    const std::string its_genus = name.substr(name.find("_genus") + 6);
    if (its_genus == "1") {
      EXPECT_TRUE(remove_handles(mesh).removed.empty());
      ++as_they_are;
      continue;
    }
    const Message said = refusal([&] { remove_handles(mesh); });
    EXPECT_THAT(said, says("genus " + its_genus + ": beside the canal there"));
    EXPECT_THAT(said, says("foramina transversaria"));
    ++refused;
  }
  EXPECT_EQ(refused, 18);
  EXPECT_EQ(as_they_are, 2);
}

}  // namespace
}  // namespace foramen
