#include "parameterize/initial_map.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "parameterize/mapped_torus.hpp"
#include "support/real_meshes.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

// Loops in the order, and therefore the orientation, that gives a positive map.
LoopSystem oriented_loops(const Mesh& mesh, VertexId basepoint, const EdgeMap<double>& weights) {
  LoopSystem loops = greedy_loops(mesh, basepoint, weights);
  try {
    harmonic_torus_map(mesh, cocycle(mesh, loops));
  } catch (const TopologyError&) {
    std::swap(loops.loops[0], loops.loops[1]);
    std::swap(loops.generators[0], loops.generators[1]);
  }
  return loops;
}

Vec2 turned_by(const TorusMap& map, const EdgeLoop& loop, const Mesh& mesh) {
  Vec2 sum = Vec2::Zero();
  for (HalfedgeId h : loop)
    sum += map.turns[mesh.to(h)] - map.turns[mesh.from(h)] + map.jumps[h].cast<double>();
  return sum;
}

TEST(HarmonicMap, HasNoFlipAndEveryVertexAtTheAverage) {
  for (const auto& [name, torus] : testing::genus1_maps()) {
    SCOPED_TRACE(name);
    EXPECT_TRUE(certify(torus.mesh, torus.map).valid());
    for (VertexId v : torus.mesh.vertices()) {
      Vec2 sum = Vec2::Zero();
      for (HalfedgeId h : torus.mesh.fan(v))
        sum += torus.map.turns[torus.mesh.to(h)] + torus.map.jumps[h].cast<double>() - torus.map.turns[v];
      EXPECT_NEAR(sum.norm(), 0, 1e-12);
    }
  }
}

TEST(HarmonicMap, OfAGridIsTheGrid) {
  const Mesh mesh = build_mesh(testing::torus_soup(8, 6));
  const TorusMap map = harmonic_torus_map(mesh, testing::grid_form(mesh, testing::regular_cells(8, 6)));
  for (int i = 0; i < 8; ++i)
    for (int j = 0; j < 6; ++j)
      EXPECT_NEAR((map.turns[VertexId(6 * i + j)] - Vec2(i / 8.0, j / 6.0)).norm(), 0, 1e-13);
}

TEST(HarmonicMap, RefusesPeriodsThatDoNotCoverTheTorusOnce) {
  const Mesh mesh = build_mesh(testing::torus_soup(8, 6));
  const Cocycle good = testing::grid_form(mesh, testing::regular_cells(8, 6));
  Cocycle swapped = good, twice = good;
  for (Vec2i& t : swapped.value) std::swap(t[0], t[1]);
  for (Vec2i& t : twice.value) t[0] *= 2;
  EXPECT_THROW(harmonic_torus_map(mesh, swapped), TopologyError);
  EXPECT_THROW(harmonic_torus_map(mesh, twice), TopologyError);
}

TEST(RectangleMap, HasNoFlipAndThePeriodsOfItsLoops) {
  int basepoints = 0;
  for (const auto& [name, torus] : testing::genus1_maps())
    for (int b = 0; b < torus.mesh.vertex_count(); b += 1 + torus.mesh.vertex_count() / 25) {
      SCOPED_TRACE(name + " basepoint " + std::to_string(b));
      const LoopSystem loops = oriented_loops(torus.mesh, VertexId(b), edge_lengths(torus.mesh));
      const TorusMap map = rectangle_torus_map(torus.mesh, loops);
      EXPECT_TRUE(certify(torus.mesh, map).valid());
      EXPECT_NEAR((turned_by(map, loops.loops[0], torus.mesh) - Vec2(1, 0)).norm(), 0, 1e-12);
      EXPECT_NEAR((turned_by(map, loops.loops[1], torus.mesh) - Vec2(0, 1)).norm(), 0, 1e-12);
      ++basepoints;
    }
  EXPECT_GT(basepoints, 100);
}

// With random edge weights, loops have spurs, shared edges and chords.
TEST(RectangleMap, CopesWithCrookedLoops) {
  const auto [mesh, map] = testing::mapped_bumpy_torus(20, 14, 7);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    Rng rng(seed);
    EdgeMap<double> weights(mesh.edge_count(), 0.0);
    for (double& w : weights) w = rng.uniform(0.01, 1);
    const LoopSystem loops = oriented_loops(mesh, VertexId(rng.below(mesh.vertex_count())), weights);
    EXPECT_TRUE(certify(mesh, rectangle_torus_map(mesh, loops)).valid());
  }
}

// Cheap edges along the first row and column, so that these are the loops.
TEST(RectangleMap, LaysTheLoopsOfAGridOnTheSides) {
  const int around = 8, tube = 6;
  const Mesh mesh = build_mesh(testing::torus_soup(around, tube));
  const auto row = [&](VertexId v) { return v.index / tube; };
  const auto column = [&](VertexId v) { return v.index % tube; };
  EdgeMap<double> weights(mesh.edge_count(), 1.0);
  for (EdgeId e : mesh.edges()) {
    const VertexId a = mesh.from(mesh.halfedge(e)), b = mesh.to(mesh.halfedge(e));
    if ((row(a) == 0 && row(b) == 0) || (column(a) == 0 && column(b) == 0)) weights[e] = 0.01;
  }
  const LoopSystem loops = oriented_loops(mesh, VertexId(0), weights);
  ASSERT_EQ(loops.loops[0].size() + loops.loops[1].size(), around + tube);
  const TorusMap map = rectangle_torus_map(mesh, loops);
  for (std::size_t k = 0; k < 2; ++k)
    for (HalfedgeId h : loops.loops[k]) {
      const double off = map.turns[mesh.from(h)][k == 0 ? 1 : 0];
      EXPECT_NEAR(off, std::round(off), 1e-13);
    }
}

TEST(InitialMapsRealData, AreValid) {
  FORAMEN_NEEDS_REAL_DATA();
  const Mesh mesh = testing::real_mesh("lumbar/verse005_L1");
  const LoopSystem loops = oriented_loops(mesh, VertexId(1234), edge_lengths(mesh));
  EXPECT_TRUE(certify(mesh, harmonic_torus_map(mesh, cocycle(mesh, loops))).valid());
  EXPECT_TRUE(certify(mesh, rectangle_torus_map(mesh, loops)).valid());
}

}  // namespace
}  // namespace foramen
