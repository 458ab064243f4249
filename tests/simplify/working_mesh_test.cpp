#include "simplify/working_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/double_torus.hpp"
#include "support/meshes.hpp"
#include "support/real_meshes.hpp"

namespace foramen {
namespace {

using testing::bumpy_torus_soup;
using testing::torus_soup;
using Triangles = std::vector<std::array<int, 3>>;

struct Case {
  std::string name;
  Mesh mesh;
  int target;
};

std::vector<Case> closed_meshes() {
  return {{"torus", build_mesh(torus_soup(60, 30)), 300},
          {"torus, as far as it goes", build_mesh(torus_soup(20, 12)), 4},
          {"bumpy torus", build_mesh(bumpy_torus_soup(50, 40, 1)), 250},
          {"bumpy torus, renumbered", build_mesh(testing::renumbered(bumpy_torus_soup(40, 40, 2), 3)), 400},
          {"thin torus", build_mesh(torus_soup(400, 5, 40, 0.5)), 500},
          {"genus 2", build_mesh(testing::bumpy_genus2_soup(40, 20, 4)), 200}};
}

// Undoes the collapses on plain triples of indices, using only the definition of the record.
Triangles restored(const Mesh& input, const WorkingMesh& working) {
  Triangles triangles(input.face_count(), {-1, -1, -1});
  for (FaceId f : working.mesh.faces())
    for (int k = 0; k < 3; ++k)
      triangles[working.face_origin[f].index][k] = working.vertex_origin[working.mesh.corners(f)[k]].index;
  for (auto c = working.collapses.rbegin(); c != working.collapses.rend(); ++c) {
    for (FaceId f : c->moved_faces)
      std::replace(triangles[f.index].begin(), triangles[f.index].end(), c->kept.index, c->removed.index);
    for (int side = 0; side < 2; ++side)
      for (int k = 0; k < 3; ++k)
        triangles[c->dropped_faces[side].index][k] = c->dropped_corners[side][k].index;
  }
  return triangles;
}

// The triangles by coordinates, each starting at its smallest corner, sorted. This does not depend on the
// numbering.
std::vector<std::vector<double>> geometry(const Mesh& mesh) {
  std::vector<std::vector<double>> out;
  for (FaceId f : mesh.faces()) {
    std::array<std::array<double, 3>, 3> t;
    for (int k = 0; k < 3; ++k)
      for (int axis = 0; axis < 3; ++axis) t[k][axis] = mesh.triangle(f)[k][axis];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    std::vector<double> flat;
    for (const auto& corner : t) flat.insert(flat.end(), corner.begin(), corner.end());
    out.push_back(flat);
  }
  std::sort(out.begin(), out.end());
  return out;
}

// 4 sqrt(3) area / (sum of squared sides): 1 for an equilateral triangle; 0.4 leaves no angle below 13.7
// degrees.
double worst_shape(const Mesh& mesh) {
  double worst = 1;
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    double squares = 0;
    for (int k = 0; k < 3; ++k) squares += (t[(k + 1) % 3] - t[k]).squaredNorm();
    worst = std::min(worst, 4 * std::sqrt(3.0) * area(t) / squares);
  }
  return worst;
}

void expect_same_collapses(const WorkingMesh& a, const WorkingMesh& b) {
  ASSERT_EQ(a.collapses.size(), b.collapses.size());
  for (std::size_t i = 0; i < a.collapses.size(); ++i) {
    EXPECT_EQ(a.collapses[i].removed, b.collapses[i].removed);
    EXPECT_EQ(a.collapses[i].kept, b.collapses[i].kept);
    EXPECT_EQ(a.collapses[i].moved_faces, b.collapses[i].moved_faces);
  }
  EXPECT_EQ(a.mesh.triangles(), b.mesh.triangles());
}

// build_mesh() has accepted the result, so it is a manifold in which no two edges join the same two vertices.
TEST(Simplify, KeepsTheTopologyAndReachesTheTarget) {
  for (const auto& [name, mesh, target] : closed_meshes()) {
    SCOPED_TRACE(name);
    const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = target});
    EXPECT_TRUE(working.mesh.is_closed());
    EXPECT_EQ(working.mesh.euler_characteristic(), mesh.euler_characteristic());
    EXPECT_LT(working.mesh.vertex_count(), mesh.vertex_count());
    if (target > 4) {
      EXPECT_EQ(working.mesh.vertex_count(), target);
    }
  }
}

// No torus has fewer than 7 vertices, no surface of genus 2 fewer than 10 (Jungerman and Ringel).
TEST(Simplify, StopsWhereTheTopologyNeedsEveryVertex) {
  EXPECT_GE(
      simplify(build_mesh(torus_soup(20, 12)), RunContext(1), {.target_vertices = 4}).mesh.vertex_count(), 7);
  EXPECT_GE(simplify(build_mesh(testing::genus2_soup(12, 8)), RunContext(1), {.target_vertices = 4})
                .mesh.vertex_count(),
            10);
}

TEST(Simplify, UndoingTheCollapsesGivesTheInputAgain) {
  for (const auto& [name, mesh, target] : closed_meshes()) {
    SCOPED_TRACE(name);
    const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = target});
    EXPECT_EQ(working.mesh.vertex_count() + static_cast<int>(working.collapses.size()), mesh.vertex_count());
    EXPECT_EQ(restored(mesh, working), mesh.triangles());
  }
}

TEST(Simplify, ACollapseMovesTheFacesBetweenTheDroppedOnesCounterClockwise) {
  const Mesh mesh = build_mesh(bumpy_torus_soup(20, 15, 5));
  const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = 299});
  ASSERT_EQ(working.collapses.size(), 1u);
  const Collapse& c = working.collapses[0];
  std::vector<FaceId> around;
  const HalfedgeId first = mesh.find_halfedge(c.removed, c.kept);
  ASSERT_TRUE(first.valid());
  for (HalfedgeId h = mesh.rotated(first); h != first; h = mesh.rotated(h)) around.push_back(Mesh::face(h));
  EXPECT_EQ(c.dropped_faces[0], Mesh::face(first));
  EXPECT_EQ(c.dropped_faces[1], around.back());
  around.pop_back();
  EXPECT_EQ(c.moved_faces, around);
}

TEST(Simplify, VerticesAreASubsetAndFacesKeepTheirIds) {
  for (const auto& [name, mesh, target] : closed_meshes()) {
    SCOPED_TRACE(name);
    const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = target});
    ASSERT_EQ(working.vertex_origin.size(), working.mesh.vertex_count());
    ASSERT_EQ(working.face_origin.size(), working.mesh.face_count());
    for (VertexId v : working.mesh.vertices())
      EXPECT_EQ(working.mesh.position(v), mesh.position(working.vertex_origin[v]));
    std::set<VertexId> gone;
    for (const Collapse& c : working.collapses) {
      EXPECT_FALSE(gone.contains(c.kept));
      EXPECT_TRUE(gone.insert(c.removed).second);
    }
    for (VertexId v : working.vertex_origin) EXPECT_FALSE(gone.contains(v));
    EXPECT_TRUE(std::is_sorted(working.vertex_origin.begin(), working.vertex_origin.end()));
    EXPECT_TRUE(std::is_sorted(working.face_origin.begin(), working.face_origin.end()));
  }
}

TEST(Simplify, KeepsTrianglesWellShapedAndValencesBounded) {
  for (const auto& [name, mesh, target] : closed_meshes()) {
    SCOPED_TRACE(name);
    const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = target});
    EXPECT_GE(worst_shape(working.mesh), std::min(0.4, worst_shape(mesh)) - 1e-12);
    for (VertexId v : working.mesh.vertices()) EXPECT_LE(working.mesh.fan(v).size(), 9u);
  }
}

TEST(Simplify, NoTriangleTurnsByMoreThan60Degrees) {
  TriangleSoup soup = torus_soup(60, 40);
  Rng rng(11);
  for (Vec3& p : soup.points) p += 0.4 * Vec3(rng.normal(), rng.normal(), rng.normal());
  const Mesh mesh = build_mesh(soup);
  const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = 300});
  Triangles triangles = mesh.triangles();
  const auto normal = [&](FaceId f) {
    const auto& t = triangles[f.index];
    return unit_normal({soup.points[t[0]], soup.points[t[1]], soup.points[t[2]]});
  };
  for (const Collapse& c : working.collapses)
    for (FaceId f : c.moved_faces) {
      const Vec3 before = normal(f);
      std::replace(triangles[f.index].begin(), triangles[f.index].end(), c.removed.index, c.kept.index);
      EXPECT_GE(before.dot(normal(f)), 0.5 - 1e-12);
    }
}

// The volume of a torus of revolution and the distance to it are known, and both may change only a little.
TEST(Simplify, StaysOnTheSurface) {
  constexpr double major = 20, minor = 8;
  const Mesh mesh = build_mesh(torus_soup(160, 80, major, minor));
  const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = 1600});
  double worst = 0;
  for (FaceId f : working.mesh.faces()) {
    const auto t = working.mesh.triangle(f);
    const Vec3 centre = (t[0] + t[1] + t[2]) / 3;
    const double tube = std::hypot(std::hypot(centre.x(), centre.y()) - major, centre.z());
    worst = std::max(worst, std::abs(tube - minor));
  }
  // A regular mesh of this number of triangles has edges of 2.1 mm, and a distance of 2.1^2 / 3 / (2 * 8) =
  // 0.09 mm at the centres of triangles.
  EXPECT_LT(worst, 0.22);
  EXPECT_NEAR(signed_volume(working.mesh), signed_volume(mesh), 0.015 * signed_volume(mesh));
}

TEST(Simplify, FlatPartsLoseTheirVerticesFirst) {
  // Flattening the top and the bottom of a torus gives flat parts in a simple way.
  TriangleSoup soup = torus_soup(80, 60);
  for (Vec3& p : soup.points) p.z() = std::clamp(p.z(), -4.0, 4.0);
  const Mesh mesh = build_mesh(soup);
  const auto flat_share = [](const Mesh& m) {
    int flat = 0;
    for (VertexId v : m.vertices()) flat += std::abs(m.position(v).z()) == 4.0;
    return static_cast<double>(flat) / m.vertex_count();
  };
  const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = 1000});
  EXPECT_LT(flat_share(working.mesh), 0.8 * flat_share(mesh));
}

TEST(Simplify, DoesNotDependOnRunsThreadsOrNumbering) {
  const TriangleSoup soup = bumpy_torus_soup(40, 30, 6);
  const Mesh mesh = build_mesh(soup), other = build_mesh(testing::renumbered(soup, 7));
  const SimplifyOptions options{.target_vertices = 300};
  const WorkingMesh working = simplify(mesh, RunContext(1), options);
  expect_same_collapses(working, simplify(mesh, RunContext(2), options));
  EXPECT_EQ(geometry(working.mesh), geometry(simplify(other, RunContext(1), options).mesh));
}

TEST(Simplify, AShiftFarFromTheOriginChangesNoCollapse) {
  TriangleSoup soup = bumpy_torus_soup(40, 30, 8);
  // Multiples of 2^-20 stay exact when a kilometre is added.
  for (Vec3& p : soup.points) p = (p * 0x1p20).array().round() * 0x1p-20;
  TriangleSoup far = soup;
  for (Vec3& p : far.points) p += Vec3(0x1p20, -0x1p20, 0x1p19);
  const SimplifyOptions options{.target_vertices = 300};
  expect_same_collapses(simplify(build_mesh(soup), RunContext(1), options),
                        simplify(build_mesh(far), RunContext(1), options));
}

TEST(Simplify, ASmallMeshComesBackUnchanged) {
  const Mesh mesh = build_mesh(torus_soup(12, 8));
  for (int target : {96, 97, 10000}) {
    const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = target});
    EXPECT_EQ(working.mesh.triangles(), mesh.triangles());
    EXPECT_TRUE(working.collapses.empty());
    for (VertexId v : mesh.vertices()) EXPECT_EQ(working.vertex_origin[v], v);
    for (FaceId f : mesh.faces()) EXPECT_EQ(working.face_origin[f], f);
  }
}

TEST(Simplify, TrianglesWithoutAreaDoNotStopIt) {
  // A few vertices are moved onto a neighbour, which gives triangles of area zero.
  TriangleSoup soup = torus_soup(40, 30);
  for (int v : {35, 400, 777}) soup.points[v] = soup.points[v + 1];
  const Mesh mesh = build_mesh(soup);
  const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = 400});
  EXPECT_EQ(working.mesh.vertex_count(), 400);
  for (FaceId f : working.mesh.faces()) EXPECT_GT(area(working.mesh.triangle(f)), 0);
}

TEST(Simplify, RefusesWhatItCannotDo) {
  TriangleSoup open = torus_soup(12, 8);
  open.triangles.pop_back();
  EXPECT_THROW(simplify(build_mesh(open), RunContext(1), {.target_vertices = 50}), TopologyError);
  EXPECT_THROW(simplify(build_mesh(torus_soup(12, 8)), RunContext(1), {.target_vertices = 3}), InvalidInput);
  const RunContext stopped(1);
  stopped.request_stop();
  EXPECT_THROW(simplify(build_mesh(torus_soup(60, 40)), stopped, {.target_vertices = 50}), Cancelled);
}

TEST(Simplify, RealVertebrae) {
  FORAMEN_NEEDS_REAL_DATA();
  for (const std::string name : {"verse005_L1", "verse561_L4", "verse823_L5"}) {
    SCOPED_TRACE(name);
    const Mesh mesh = testing::real_mesh("lumbar/" + name);
    const WorkingMesh working = simplify(mesh, RunContext(1), {.target_vertices = 10000});
    EXPECT_EQ(working.mesh.vertex_count(), 10000);
    EXPECT_EQ(working.mesh.euler_characteristic(), 0);
    EXPECT_EQ(restored(mesh, working), mesh.triangles());
    EXPECT_NEAR(signed_volume(working.mesh), signed_volume(mesh), 4e-3 * signed_volume(mesh));
    EXPECT_NEAR(total_area(working.mesh), total_area(mesh), 1e-2 * total_area(mesh));
    // Every removed vertex lies near a triangle at the vertex into which it was finally collapsed.
    VertexMap<VertexId> heir(mesh.vertex_count());
    for (VertexId v : mesh.vertices()) heir[v] = v;
    double worst = 0;
    for (auto c = working.collapses.rbegin(); c != working.collapses.rend(); ++c) {
      heir[c->removed] = heir[c->kept];
      worst = std::max(worst, (mesh.position(c->removed) - mesh.position(heir[c->kept])).norm());
    }
    EXPECT_LT(worst, 6);
    EXPECT_GT(worst, 0);
  }
}

}  // namespace
}  // namespace foramen
