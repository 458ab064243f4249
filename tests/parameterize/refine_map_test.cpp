#include "parameterize/refine_map.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "parameterize/initial_map.hpp"
#include "parameterize/optimise_map.hpp"
#include "support/meshes.hpp"
#include "support/real_meshes.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;

constexpr int around = 48, tube = 32;

// The regular map of torus_soup(around, tube): vertex (i, j) is at (i/around, j/tube).
TorusMap grid_map(const Mesh& mesh) {
  TorusMap map;
  map.turns = VertexMap<Vec2>(mesh.vertex_count(), Vec2::Zero());
  map.jumps = HalfedgeMap<Vec2i>(mesh.halfedge_count(), Vec2i::Zero());
  for (VertexId v : mesh.vertices())
    map.turns[v] =
        Vec2(static_cast<double>(v.index / tube) / around, static_cast<double>(v.index % tube) / tube);
  for (HalfedgeId h : mesh.halfedges()) {
    const Vec2 step = map.turns[mesh.to(h)] - map.turns[mesh.from(h)];
    map.jumps[h] = -Vec2i(static_cast<int>(std::round(step.x())), static_cast<int>(std::round(step.y())));
  }
  return map;
}

// The closed form on the working mesh that a closed form of the input becomes. Before each collapse, the
// removed vertex is shifted by whole turns, so that its edge to the kept vertex has no jump.
Cocycle carried(const Mesh& input, const WorkingMesh& working, Cocycle form) {
  auto triangles = input.triangles();
  for (const Collapse& c : working.collapses) {
    std::vector<FaceId> star = c.moved_faces;
    star.insert(star.end(), c.dropped_faces.begin(), c.dropped_faces.end());
    Vec2i shift = Vec2i::Zero();
    for (int k = 0; k < 3; ++k)
      if (c.dropped_corners[0][k] == c.removed) shift = form.value[Mesh::halfedge(c.dropped_faces[0], k)];
    for (FaceId f : star)
      for (int k = 0; k < 3; ++k)
        if (triangles[f.index][k] == c.removed.index) {
          form.value[Mesh::halfedge(f, k)] -= shift;
          form.value[Mesh::prev(Mesh::halfedge(f, k))] += shift;
        }
    for (FaceId f : c.moved_faces)
      std::replace(triangles[f.index].begin(), triangles[f.index].end(), c.removed.index, c.kept.index);
  }
  Cocycle out{HalfedgeMap<Vec2i>(working.mesh.halfedge_count(), Vec2i::Zero())};
  for (HalfedgeId h : working.mesh.halfedges())
    out.value[h] = form.value[Mesh::halfedge(working.face_origin[Mesh::face(h)], h.index % 3)];
  return out;
}

// Whether two closed forms have the same periods, that is, whether their difference is the coboundary of
// integers at the vertices.
bool same_periods(const Mesh& mesh, const HalfedgeMap<Vec2i>& a, const HalfedgeMap<Vec2i>& b) {
  VertexMap<Vec2i> potential(mesh.vertex_count(), Vec2i::Zero());
  VertexMap<char> known(mesh.vertex_count(), 0);
  std::vector<VertexId> stack = {VertexId(0)};
  known[VertexId(0)] = 1;
  while (!stack.empty()) {
    const VertexId v = stack.back();
    stack.pop_back();
    for (HalfedgeId h : mesh.fan(v)) {
      if (known[mesh.to(h)]) continue;
      known[mesh.to(h)] = 1;
      potential[mesh.to(h)] = potential[v] + a[h] - b[h];
      stack.push_back(mesh.to(h));
    }
  }
  for (HalfedgeId h : mesh.halfedges())
    if (potential[mesh.to(h)] - potential[mesh.from(h)] != a[h] - b[h]) return false;
  return true;
}

// One collapse without simplify().
WorkingMesh collapsed(const Mesh& mesh, HalfedgeId h) {
  const VertexId removed = mesh.from(h), kept = mesh.to(h);
  Collapse c;
  c.removed = removed;
  c.kept = kept;
  c.dropped_faces = {Mesh::face(h), Mesh::face(mesh.twin(h))};
  for (int side = 0; side < 2; ++side) c.dropped_corners[side] = mesh.corners(c.dropped_faces[side]);
  for (HalfedgeId k = mesh.rotated(h); Mesh::face(k) != c.dropped_faces[1]; k = mesh.rotated(k))
    c.moved_faces.push_back(Mesh::face(k));
  WorkingMesh out;
  TriangleSoup soup = mesh.soup();
  std::vector<int> number(soup.points.size());
  for (int v = 0; v < mesh.vertex_count(); ++v) number[v] = v - (v > removed.index);
  number[removed.index] = number[kept.index];
  soup.points.erase(soup.points.begin() + removed.index);
  soup.triangles.clear();
  for (VertexId v : mesh.vertices())
    if (v != removed) out.vertex_origin.values().push_back(v);
  for (FaceId f : mesh.faces()) {
    if (f == c.dropped_faces[0] || f == c.dropped_faces[1]) continue;
    const auto corners = mesh.corners(f);
    soup.triangles.push_back({number[corners[0].index], number[corners[1].index], number[corners[2].index]});
    out.face_origin.values().push_back(f);
  }
  out.mesh = build_mesh(soup);
  out.collapses = {c};
  return out;
}

struct Refined {
  Mesh input;
  WorkingMesh working;
  TorusMap coarse, fine;
};

Refined refine_torus(const TriangleSoup& soup, int target) {
  Refined r;
  r.input = build_mesh(soup);
  r.working = simplify(r.input, RunContext(1), {.target_vertices = target});
  r.coarse = harmonic_torus_map(r.working.mesh, carried(r.input, r.working, {grid_map(r.input).jumps}));
  r.fine = refine_map(r.input, r.working, r.coarse);
  return r;
}

double total_signed_area(const Mesh& mesh, const TorusMap& map) {
  double sum = 0;
  for (FaceId f : mesh.faces()) sum += signed_area(mesh, map, f);
  return sum;
}

int flips(const Mesh& mesh, const TorusMap& map) {
  int count = 0;
  for (FaceId f : mesh.faces()) count += !(signed_area(mesh, map, f) > 0);
  return count;
}

TEST(RefineMap, IsOneToOneOfDegreeOneWithThePeriodsOfTheCoarseMap) {
  for (int seed : {1, 2, 3})
    for (int target : {60, 200, 1000}) {
      SCOPED_TRACE(std::to_string(seed) + " to " + std::to_string(target));
      const Refined r = refine_torus(testing::bumpy_torus_soup(around, tube, seed), target);
      EXPECT_GT(r.working.collapses.size(), 400u);
      EXPECT_EQ(flips(r.input, r.fine), 0);
      EXPECT_NEAR(total_signed_area(r.input, r.fine), 1, 1e-12);
      EXPECT_TRUE(is_closed_form(r.input, {r.fine.jumps}));
      EXPECT_TRUE(same_periods(r.input, r.fine.jumps, grid_map(r.input).jumps));
      EXPECT_TRUE(certify(r.input, quantised(r.input, r.fine)).valid());
    }
}

TEST(RefineMap, LeavesTheWorkingVerticesWhereTheyAre) {
  const Refined r = refine_torus(testing::bumpy_torus_soup(around, tube, 4), 300);
  for (VertexId v : r.working.mesh.vertices())
    EXPECT_EQ(r.fine.turns[r.working.vertex_origin[v]], r.coarse.turns[v]);
}

// The purpose of refinement is that the optimisation on the input mesh starts near its minimum.
TEST(RefineMap, OfAMapOfLeastDistortionIsNearlyOne) {
  const Refined r = refine_torus(testing::bumpy_torus_soup(around, tube, 11), 400);
  const RunContext ctx(1);
  const TorusMap best = optimise_map(r.working.mesh, r.coarse, ctx).map;
  const TorusMap fine = refine_map(r.input, r.working, best);
  const OptimisedMap polished = optimise_map(r.input, fine, ctx);
  const OptimisedMap from_harmonic = optimise_map(r.input, r.fine, ctx);
  EXPECT_NEAR(polished.final_energy, from_harmonic.final_energy, 1e-3 * from_harmonic.final_energy);
  EXPECT_LT(polished.initial_energy, 1.0015 * polished.final_energy);
  EXPECT_LT(polished.iterations, from_harmonic.iterations);
}

TEST(RefineMap, WithoutCollapsesTheMapIsTheSame) {
  const Mesh mesh = build_mesh(testing::torus_soup(around, tube));
  const WorkingMesh working = simplify(mesh, RunContext(1), {});
  const TorusMap map = grid_map(mesh), fine = refine_map(mesh, working, map);
  EXPECT_EQ(fine.turns, map.turns);
  EXPECT_EQ(fine.jumps, map.jumps);
}

// Mean-value coordinates are exact for affine maps. Therefore, a removed vertex of a flat patch returns to
// its place, from every neighbour and also across the cut.
TEST(RefineMap, AFlatPatchIsRestoredExactly) {
  for (const int centre_i : {20, 0})
    for (const int centre_j : {10, 31}) {
      TriangleSoup soup = testing::torus_soup(around, tube);
      const auto id = [](int i, int j) { return (i + around) % around * tube + (j + tube) % tube; };
      for (int di = -1; di <= 1; ++di)
        for (int dj = -1; dj <= 1; ++dj)
          soup.points[id(centre_i + di, centre_j + dj)] =
              Vec3(3.0 * di + 0.5 * dj, 2.0 * dj - 0.25 * di, di + dj);
      const Mesh mesh = build_mesh(soup);
      const VertexId v(id(centre_i, centre_j));
      const TorusMap exact = grid_map(mesh);
      for (HalfedgeId h : mesh.fan(v)) {
        const WorkingMesh working = collapsed(mesh, h);
        TorusMap coarse;
        // The map is the restriction of the exact map. The shift in carried() takes account of the jumps of
        // the removed vertex.
        coarse.jumps = carried(mesh, working, {exact.jumps}).value;
        for (VertexId w : working.vertex_origin) coarse.turns.values().push_back(exact.turns[w]);
        const TorusMap fine = refine_map(mesh, working, coarse);
        const Vec2 difference = fine.turns[v] - exact.turns[v];
        EXPECT_LT((difference - Vec2(difference.array().round())).norm(), 1e-14);
        EXPECT_TRUE(same_periods(mesh, fine.jumps, exact.jumps));
        EXPECT_TRUE(is_closed_form(mesh, {fine.jumps}));
      }
    }
}

TEST(RefineMap, DoesNotDependOnWhereTheRectangleIsCut) {
  const Refined r = refine_torus(testing::bumpy_torus_soup(around, tube, 5), 200);
  TorusMap moved = r.coarse;
  for (Vec2& p : moved.turns) p += Vec2(0.375, -2.25);
  const TorusMap other = refine_map(r.input, r.working, wrapped(r.working.mesh, moved));
  EXPECT_TRUE(same_periods(r.input, other.jumps, r.fine.jumps));
  for (VertexId v : r.input.vertices()) {
    const Vec2 difference = other.turns[v] - r.fine.turns[v] - Vec2(0.375, -0.25);
    EXPECT_LT((difference - Vec2(difference.array().round())).norm(), 1e-9);
  }
}

TEST(RefineMap, DoesNotDependOnThePoseOfTheSurface) {
  const Refined r = refine_torus(testing::bumpy_torus_soup(around, tube, 6), 200);
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Vec3(1, 2, -1).normalized())).pretranslate(Vec3(100, -30, 7));
  const TorusMap other = refine_map(transformed(r.input, motion), r.working, r.coarse);
  for (VertexId v : r.input.vertices()) EXPECT_LT((other.turns[v] - r.fine.turns[v]).norm(), 1e-8);
}

// In twisted bases, all triangles are slivers.
TEST(RefineMap, KeepsTheOrientationInAnyLattice) {
  const Refined r = refine_torus(testing::bumpy_torus_soup(around, tube, 7), 150);
  for (int twists : {1, -3, 20}) {
    SCOPED_TRACE(twists);
    Eigen::Matrix2i b;
    b << 1, twists, 0, 1;
    TorusMap twisted = change_basis(r.coarse, b);
    twisted.lattice << 1.6, 0.3, 0, 1 / 1.6;
    const TorusMap fine = refine_map(r.input, r.working, twisted);
    EXPECT_EQ(fine.lattice, twisted.lattice);
    EXPECT_EQ(flips(r.input, fine), 0);
    EXPECT_NEAR(total_signed_area(r.input, fine), 1, 1e-12);
    EXPECT_TRUE(certify(r.input, quantised(r.input, fine)).valid());
  }
}

// All positions in space are noise, so they do not help to place a vertex. Only the kernel of its star is
// left.
TEST(RefineMap, KeepsTheOrientationWhateverTheSurface) {
  const Refined r = refine_torus(testing::bumpy_torus_soup(around, tube, 8), 100);
  Rng rng(9);
  std::vector<Vec3> noise(r.input.positions().begin(), r.input.positions().end());
  for (Vec3& p : noise) p = Vec3(rng.normal(), rng.normal(), rng.normal());
  std::vector<Vec3> one_point(noise.size(), Vec3(1, 2, 3));
  for (const auto& positions : {noise, one_point}) {
    const TorusMap fine = refine_map(r.input.with_positions(positions), r.working, r.coarse);
    EXPECT_EQ(flips(r.input, fine), 0);
    EXPECT_NEAR(total_signed_area(r.input, fine), 1, 1e-12);
  }
}

template <class Error, class Action>
std::string refusal(const Action& action) {
  try {
    action();
  } catch (const Error& e) {
    return e.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

TEST(RefineMap, RefusesWhatDoesNotFit) {
  const Refined r = refine_torus(testing::bumpy_torus_soup(around, tube, 10), 200);
  TorusMap flipped = r.coarse;
  flipped.turns[r.working.mesh.corners(FaceId(0))[0]] += Vec2(0.5, 0.5);
  EXPECT_THAT(refusal<InvalidInput>([&] { refine_map(r.input, r.working, flipped); }), HasSubstr("triangle"));
  EXPECT_THAT(refusal<InvalidInput>([&] { refine_map(r.input, r.working, r.fine); }),
              HasSubstr("working mesh 200"));
  const Mesh other = build_mesh(testing::torus_soup(around, tube + 1));
  EXPECT_THAT(refusal<InvalidInput>([&] { refine_map(other, r.working, r.coarse); }),
              HasSubstr("do not belong"));
}

TEST(RefineMap, RealVertebrae) {
  FORAMEN_NEEDS_REAL_DATA();
  for (const std::string name : {"verse005_L5", "verse631_L3", "verse823_L4"}) {
    SCOPED_TRACE(name);
    const Mesh mesh = testing::real_mesh("lumbar/" + name);
    const WorkingMesh working = simplify(mesh, RunContext(1), {});
    const LoopSystem loops = greedy_loops(working.mesh, VertexId(0), edge_lengths(working.mesh));
    Cocycle form = cocycle(working.mesh, loops);
    TorusMap coarse;
    try {
      coarse = harmonic_torus_map(working.mesh, form);
    } catch (const TopologyError&) {  // the loops cross the other way
      for (Vec2i& value : form.value) value = Vec2i(value.y(), value.x());
      coarse = harmonic_torus_map(working.mesh, form);
    }
    const MapCertificate certificate = certify(mesh, quantised(mesh, refine_map(mesh, working, coarse)));
    EXPECT_EQ(certificate.flipped, 0);
    EXPECT_NEAR(certificate.degree, 1, 1e-12);
    EXPECT_TRUE(certificate.periods_consistent);
  }
}

}  // namespace
}  // namespace foramen
