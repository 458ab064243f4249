#include "foramen/topology/shortest_loops.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <map>
#include <numbers>
#include <queue>
#include <tuple>

#include "foramen/core/error.hpp"
#include "support/exhaustive_loops.hpp"
#include "support/real_meshes.hpp"
#include "topology/loop_fixtures.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

using namespace foramen::testing;

TriangleSoup tetrahedron_soup() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
}

// The perimeter of a regular polygon.
double perimeter(int sides, double radius) { return 2 * radius * sides * std::sin(std::numbers::pi / sides); }

// Of all closed walks from the basepoint, the shortest in each class of homology, by Dijkstra in the covering
// of (2 reach + 1)^2 sheets.
std::map<std::pair<int, int>, double> shortest_by_class(const Mesh& mesh, const Cocycle& form,
                                                        VertexId basepoint, const EdgeMap<double>& lengths,
                                                        int reach) {
  using Place = std::tuple<int, int, int>;  // vertex and sheet
  std::map<Place, double> distance;
  std::priority_queue<std::pair<double, Place>, std::vector<std::pair<double, Place>>, std::greater<>> queue;
  const auto improve = [&](const Place& place, double d) {
    const auto [entry, fresh] = distance.emplace(place, d);
    if (!fresh && entry->second <= d) return;
    entry->second = d;
    queue.emplace(d, place);
  };
  improve({basepoint.index, 0, 0}, 0);
  while (!queue.empty()) {
    const auto [d, place] = queue.top();
    queue.pop();
    if (d > distance[place]) continue;
    const auto [v, x, y] = place;
    for (HalfedgeId h : mesh.fan(VertexId(v))) {
      const Vec2i sheet = Vec2i(x, y) + form.value[h];
      if (sheet.cwiseAbs().maxCoeff() <= reach)
        improve({mesh.to(h).index, sheet.x(), sheet.y()}, d + lengths[mesh.edge(h)]);
    }
  }
  std::map<std::pair<int, int>, double> by_class;
  for (int x = -reach; x <= reach; ++x)
    for (int y = -reach; y <= reach; ++y)
      if (x != 0 || y != 0) by_class[{x, y}] = distance.at({basepoint.index, x, y});
  return by_class;
}

// Lengths of the two shortest walks of independent classes.
std::array<double, 2> successive_minima(const std::map<std::pair<int, int>, double>& by_class) {
  const auto shorter = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto first = *std::min_element(by_class.begin(), by_class.end(), shorter);
  double second = std::numeric_limits<double>::infinity();
  for (const auto& [c, length] : by_class)
    if (c.first * first.first.second != c.second * first.first.first) second = std::min(second, length);
  return {first.second, second};
}

TEST(GreedyLoops, AreClosedWalksFromTheBasepoint) {
  for (const auto& [name, mesh, genus] : surfaces_with_handles()) {
    SCOPED_TRACE(name);
    const auto lengths = edge_lengths(mesh);
    for (VertexId basepoint : some_vertices(mesh, 12)) {
      const LoopSystem system = greedy_loops(mesh, basepoint, lengths);
      ASSERT_EQ(system.loops.size(), 2 * genus);
      double sum = 0, previous = 0;
      for (std::size_t k = 0; k < system.loops.size(); ++k) {
        const EdgeLoop& loop = system.loops[k];
        EXPECT_TRUE(is_closed_walk(mesh, loop));
        EXPECT_EQ(mesh.from(loop.front()), basepoint);
        EXPECT_THAT(loop, ::testing::Contains(system.generators[k]));
        const double length = loop_length(mesh, loop, lengths);
        EXPECT_GE(length, previous * (1 - 1e-12));
        previous = length;
        sum += length;
      }
      EXPECT_NEAR(system.length, sum, 1e-10);
    }
  }
}

TEST(GreedyLoops, TreeHoldsShortestPaths) {
  for (const auto& [name, mesh, genus] : surfaces_with_handles()) {
    SCOPED_TRACE(name);
    const auto lengths = edge_lengths(mesh);
    const VertexId basepoint(mesh.vertex_count() / 2);
    const LoopSystem system = greedy_loops(mesh, basepoint, lengths);
    const ShortestPaths paths = shortest_paths(mesh, basepoint, lengths);
    for (VertexId v : mesh.vertices()) {
      double d = 0;
      for (HalfedgeId h = system.tree_parent[v]; h.valid(); h = system.tree_parent[mesh.from(h)])
        d += lengths[mesh.edge(h)];
      EXPECT_NEAR(d, paths.distance[v], 1e-10);
      const auto walk = path_to(mesh, paths, v);
      EXPECT_NEAR(loop_length(mesh, walk, lengths), paths.distance[v], 1e-10);
      EXPECT_EQ(walk.empty() ? basepoint : mesh.to(walk.back()), v);
    }
  }
}

// The reference does not use trees and cotrees.
TEST(GreedyLoops, AreTheShortestIndependentClosedWalks) {
  for (const TriangleSoup& soup :
       {torus_soup(9, 7), bumpy_torus_soup(12, 10, 1), bumpy_torus_soup(16, 8, 2)}) {
    const Mesh mesh = build_mesh(soup);
    const auto lengths = edge_lengths(mesh);
    const Cocycle form = cocycle(mesh, greedy_loops(mesh, VertexId(0), lengths));
    for (VertexId basepoint : some_vertices(mesh, 7)) {
      const LoopSystem system = greedy_loops(mesh, basepoint, lengths);
      const auto expected = successive_minima(shortest_by_class(mesh, form, basepoint, lengths, 3));
      EXPECT_NEAR(loop_length(mesh, system.loops[0], lengths), expected[0], 1e-10);
      EXPECT_NEAR(loop_length(mesh, system.loops[1], lengths), expected[1], 1e-10);
    }
  }
}

TEST(GreedyLoops, TakeWeightsOfAnyRange) {
  const Mesh mesh = build_mesh(bumpy_torus_soup(20, 14, 7));
  const VertexId basepoint(33);
  EXPECT_EQ(greedy_loops(mesh, basepoint, EdgeMap<double>(mesh.edge_count(), 0.0)).length, 0);
  for (const auto& [scale, power] : {std::pair{1e-300, 1.0}, {1e300, 1.0}, {1.0, 12.0}, {1.0, 40.0}}) {
    auto weights = edge_lengths(mesh);
    for (double& w : weights) w = scale * std::pow(w, power);
    const LoopSystem system = greedy_loops(mesh, basepoint, weights);
    const Cocycle form = cocycle(mesh, system);
    const auto expected = successive_minima(shortest_by_class(mesh, form, basepoint, weights, 3));
    EXPECT_NEAR(system.length / (expected[0] + expected[1]), 1, 1e-12);
  }
}

TEST(GreedyLoops, ZeroWeightsKeepATree) {
  const Mesh mesh = build_mesh(bumpy_torus_soup(20, 14, 7));
  auto weights = edge_lengths(mesh);
  for (EdgeId e : mesh.edges())
    if (e.index % 3 != 0) weights[e] = 0;
  const LoopSystem system = greedy_loops(mesh, VertexId(5), weights);
  for (VertexId v : mesh.vertices()) {
    int steps = 0;
    for (HalfedgeId h = system.tree_parent[v]; h.valid() && steps <= mesh.vertex_count();
         h = system.tree_parent[mesh.from(h)])
      ++steps;
    ASSERT_LT(steps, mesh.vertex_count());
  }
  EXPECT_EQ(integrate(cocycle(mesh, system), system.loops[1]), Vec2i::UnitY());
}

// All lengths are equal, and the choice among equal loops must not depend on the numbering.
TEST(GreedyLoops, RenumberingChangesNothing) {
  for (const TriangleSoup& soup : {torus_soup(20, 12), bumpy_torus_soup(20, 12, 4), genus2_soup(10, 8)}) {
    const Mesh mesh = build_mesh(soup), other = build_mesh(renumbered(soup, 11));
    const EdgeMap<double> ones(mesh.edge_count(), 1.0);
    for (VertexId v : some_vertices(mesh, 9)) {
      const VertexId same = vertex_at(other, mesh.position(v));
      for (bool by_length : {true, false}) {
        const LoopSystem a = greedy_loops(mesh, v, by_length ? edge_lengths(mesh) : ones);
        const LoopSystem b = greedy_loops(other, same, by_length ? edge_lengths(other) : ones);
        EXPECT_EQ(a.length, b.length);
        for (std::size_t k = 0; k < a.loops.size(); ++k)
          EXPECT_EQ(positions_of(mesh, a.loops[k]), positions_of(other, b.loops[k]));
      }
    }
  }
}

TEST(ShortestLoops, OfATorusOfRevolutionAreATubeAndTheInnerRim) {
  const Mesh mesh = build_mesh(torus_soup(48, 24));
  const auto result = shortest_loops(mesh, edge_lengths(mesh), RunContext(2));
  EXPECT_NEAR(result.system.length, perimeter(24, 8) + perimeter(48, 12), 1e-10);
  // All vertices of the inner rim are equally good. The one with the smallest position is at x = -12.
  EXPECT_NEAR((mesh.position(result.system.basepoint) - Vec3(-12, 0, 0)).norm(), 0, 1e-12);
}

TEST(ShortestLoops, AreAsShortAsExhaustiveSearchFinds) {
  const RunContext ctx(2);
  for (const TriangleSoup& soup :
       {torus_soup(3, 3), torus_soup(5, 4), torus_soup(24, 12), torus_soup(12, 30, 20, 15),
        bumpy_torus_soup(24, 18, 1), bumpy_torus_soup(16, 30, 2), bumpy_torus_soup(30, 12, 3),
        bumpy_torus_soup(60, 50, 4), genus2_soup(10, 8), bumpy_genus2_soup(16, 12, 5),
        bumpy_genus2_soup(24, 8, 6)}) {
    const Mesh mesh = build_mesh(soup);
    SCOPED_TRACE(std::to_string(mesh.vertex_count()) + " vertices");
    const auto lengths = edge_lengths(mesh);
    const LoopSystem expected = testing::shortest_loops_exhaustive(mesh, lengths, ctx);
    const auto result = shortest_loops(mesh, lengths, ctx);
    EXPECT_NEAR(result.system.length, expected.length, 1e-12 * expected.length);
    EXPECT_LE(result.evaluations, mesh.vertex_count());
  }
}

TEST(ShortestLoops, RuleOutMostBasepoints) {
  const Mesh torus = build_mesh(bumpy_torus_soup(60, 50, 4)), two = build_mesh(bumpy_genus2_soup(40, 20, 4));
  EXPECT_LT(shortest_loops(torus, edge_lengths(torus), RunContext(1)).evaluations, torus.vertex_count() / 8);
  EXPECT_LT(shortest_loops(two, edge_lengths(two), RunContext(1)).evaluations, two.vertex_count() / 8);
}

TEST(ShortestLoops, RenumberingAndThreadsChangeNothing) {
  for (const TriangleSoup& soup :
       {torus_soup(30, 16), bumpy_torus_soup(30, 16, 9), bumpy_genus2_soup(16, 12, 9)}) {
    const Mesh mesh = build_mesh(soup), other = build_mesh(renumbered(soup, 21));
    const auto a = shortest_loops(mesh, edge_lengths(mesh), RunContext(1));
    const auto b = shortest_loops(mesh, edge_lengths(mesh), RunContext(2));
    const auto c = shortest_loops(other, edge_lengths(other), RunContext(2));
    EXPECT_EQ(a.evaluations, b.evaluations);
    EXPECT_EQ(a.evaluations, c.evaluations);
    EXPECT_EQ(a.system.loops, b.system.loops);
    EXPECT_EQ(a.system.length, c.system.length);
    EXPECT_EQ(mesh.position(a.system.basepoint), other.position(c.system.basepoint));
    for (std::size_t k = 0; k < a.system.loops.size(); ++k)
      EXPECT_EQ(positions_of(mesh, a.system.loops[k]), positions_of(other, c.system.loops[k]));
  }
}

TEST(ShortestLoops, OfRealDataAreNoLongerThanFromAnyBasepoint) {
  FORAMEN_NEEDS_REAL_DATA();
  const Mesh mesh = real_mesh("lumbar/verse005_L1");
  const auto lengths = edge_lengths(mesh);
  const auto result = shortest_loops(mesh, lengths, RunContext(2));
  EXPECT_LT(result.evaluations, mesh.vertex_count() / 30);
  for (VertexId v : some_vertices(mesh, 100))
    EXPECT_GE(greedy_loops(mesh, v, lengths).length, result.system.length);
  const ShortestPaths near = shortest_paths(mesh, result.system.basepoint, lengths);
  for (VertexId v : mesh.vertices()) {
    if (near.distance[v] > 3) continue;
    EXPECT_GE(greedy_loops(mesh, v, lengths).length, result.system.length);
  }
}

TEST(ShortestLoops, RefuseOneBrokenThing) {
  const RunContext ctx(1);
  TriangleSoup open = torus_soup(8, 6);
  open.triangles.pop_back();
  const Mesh with_hole = build_mesh(open);
  EXPECT_THROW(shortest_loops(with_hole, edge_lengths(with_hole), ctx), TopologyError);

  TriangleSoup pair = torus_soup(8, 6);
  const TriangleSoup torus = torus_soup(8, 6);
  for (const Vec3& p : torus.points) pair.points.emplace_back(p + Vec3(100, 0, 0));
  for (const auto& t : torus.triangles) pair.triangles.push_back({t[0] + 48, t[1] + 48, t[2] + 48});
  const Mesh two = build_mesh(pair);
  EXPECT_THROW(greedy_loops(two, VertexId(0), edge_lengths(two)), TopologyError);

  const Mesh sphere = build_mesh(tetrahedron_soup());
  EXPECT_THROW(shortest_loops(sphere, edge_lengths(sphere), ctx), TopologyError);
  EXPECT_TRUE(greedy_loops(sphere, VertexId(2), edge_lengths(sphere)).loops.empty());

  const Mesh mesh = build_mesh(torus);
  for (double bad :
       {-1e-9, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    auto lengths = edge_lengths(mesh);
    lengths[EdgeId(7)] = bad;
    EXPECT_THROW(greedy_loops(mesh, VertexId(0), lengths), InvalidInput);
  }
}

TEST(ShortestLoops, StopAtTheLimitAndOnRequest) {
  const Mesh mesh = build_mesh(torus_soup(40, 20));
  const auto lengths = edge_lengths(mesh);
  EXPECT_THROW(shortest_loops(mesh, lengths, RunContext(1), {.evaluation_limit = 5}), ConvergenceError);
  const RunContext stopped(1);
  stopped.request_stop();
  EXPECT_THROW(shortest_loops(mesh, lengths, stopped), Cancelled);
}

}  // namespace
}  // namespace foramen
