#include "foramen/topology/handle_loops.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/double_torus.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using testing::bumpy_genus2_soup;
using testing::bumpy_torus_soup;
using testing::renumbered;
using testing::torus_soup;

constexpr int around = 24, tube = 12;

VertexId grid(int i, int j) { return VertexId((i % around) * tube + j % tube); }

EdgeLoop round_the_tube(const Mesh& mesh, int i) {
  EdgeLoop loop;
  for (int j = 0; j < tube; ++j) loop.push_back(mesh.find_halfedge(grid(i, j), grid(i, j + 1)));
  return loop;
}

EdgeLoop round_the_axis(const Mesh& mesh, int j) {
  EdgeLoop loop;
  for (int i = 0; i < around; ++i) loop.push_back(mesh.find_halfedge(grid(i, j), grid(i + 1, j)));
  return loop;
}

EdgeLoop joined(EdgeLoop first, const EdgeLoop& second) {
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

TEST(LoopKind, OfATorus) {
  const Mesh mesh = build_mesh(torus_soup(around, tube));
  EXPECT_EQ(loop_kind(mesh, round_the_tube(mesh, 3)), LoopKind::handle);
  for (int j : {0, tube / 2, 2}) EXPECT_EQ(loop_kind(mesh, round_the_axis(mesh, j)), LoopKind::tunnel);
  EXPECT_EQ(loop_kind(mesh, joined(round_the_tube(mesh, 0), round_the_axis(mesh, 0))), LoopKind::neither);
}

TEST(LoopKind, TurnedInsideOutTheTwoChangePlaces) {
  const Mesh mesh = reversed(build_mesh(torus_soup(around, tube)));
  EdgeLoop tube_loop, axis_loop;
  for (int j = 0; j < tube; ++j) tube_loop.push_back(mesh.find_halfedge(grid(3, j), grid(3, j + 1)));
  for (int i = 0; i < around; ++i) axis_loop.push_back(mesh.find_halfedge(grid(i, 2), grid(i + 1, 2)));
  EXPECT_EQ(loop_kind(mesh, tube_loop), LoopKind::tunnel);
  EXPECT_EQ(loop_kind(mesh, axis_loop), LoopKind::handle);
}

TEST(LoopKind, NeitherMotionNorDirectionMatters) {
  const RigidTransform motion = Eigen::Translation3d(300, -120, 40) *
                                Eigen::AngleAxisd(2.1, Vec3(1, 2, 3).normalized()) *
                                RigidTransform::Identity();
  const Mesh mesh = transformed(build_mesh(bumpy_torus_soup(around, tube, 5)), motion);
  EdgeLoop back;
  for (HalfedgeId h : round_the_tube(mesh, 3)) back.insert(back.begin(), mesh.twin(h));
  EXPECT_EQ(loop_kind(mesh, back), LoopKind::handle);
  EXPECT_EQ(loop_kind(mesh, round_the_axis(mesh, 2)), LoopKind::tunnel);
}

TEST(LoopKind, ALoopWithoutEdgesIsRefused) {
  EXPECT_THROW(loop_kind(build_mesh(torus_soup(6, 5)), {}), InvalidInput);
}

// All shortest paths in the double cover, by the algorithm of Floyd and Warshall.
double brute_force_crossing(const Mesh& mesh, const EdgeLoop& loop, const EdgeMap<double>& lengths) {
  EdgeMap<int> crossings(mesh.edge_count(), 0);
  for (std::size_t i = 0; i < loop.size(); ++i) {  // edges left of the loop, between its edge i and the next
    const HalfedgeId next = loop[(i + 1) % loop.size()];
    HalfedgeId h = mesh.twin(loop[i]);
    // Clockwise from the edge to the previous vertex, that is, to the left of the loop.
    for (h = Mesh::next(mesh.twin(h)); h != next; h = Mesh::next(mesh.twin(h))) ++crossings[mesh.edge(h)];
  }
  const std::size_t n = mesh.vertex_count();
  std::vector<std::vector<double>> d(2 * n,
                                     std::vector<double>(2 * n, std::numeric_limits<double>::infinity()));
  for (HalfedgeId h : mesh.halfedges())
    for (std::size_t sheet = 0; sheet < 2; ++sheet) {
      const std::size_t other = (sheet + static_cast<std::size_t>(crossings[mesh.edge(h)])) % 2;
      double& cell = d[static_cast<std::size_t>(mesh.from(h).index) + sheet * n]
                      [static_cast<std::size_t>(mesh.to(h).index) + other * n];
      cell = std::min(cell, lengths[mesh.edge(h)]);
    }
  for (std::size_t k = 0; k < 2 * n; ++k)
    for (std::size_t i = 0; i < 2 * n; ++i)
      for (std::size_t j = 0; j < 2 * n; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
  double best = std::numeric_limits<double>::infinity();
  for (std::size_t v = 0; v < n; ++v) best = std::min(best, d[v][v + n]);
  return best;
}

TEST(ShortestCrossingLoop, IsThatOfExhaustiveSearch) {
  const auto expect_shortest = [](const Mesh& mesh) {
    const auto lengths = edge_lengths(mesh);
    for (const EdgeLoop& loop : greedy_loops(mesh, VertexId(3), lengths).loops) {
      const EdgeLoop found = shortest_crossing_loop(mesh, loop, lengths);
      EXPECT_NEAR(loop_length(mesh, found, lengths), brute_force_crossing(mesh, loop, lengths), 1e-9);
      for (std::size_t k = 0; k < found.size(); ++k)
        EXPECT_EQ(mesh.to(found[k]), mesh.from(found[(k + 1) % found.size()]));
    }
  };
  for (std::uint64_t seed : {1, 2, 3}) {
    SCOPED_TRACE(seed);
    expect_shortest(build_mesh(bumpy_torus_soup(9, 6, seed)));
    expect_shortest(build_mesh(bumpy_genus2_soup(7, 5, seed)));
  }
}

TEST(ShortestCrossingLoop, OfATorusRunTheOtherWay) {
  const Mesh mesh = build_mesh(torus_soup(around, tube));
  const auto lengths = edge_lengths(mesh);
  const auto polygon = [](int sides, double radius) {
    return 2 * sides * radius * std::sin(std::numbers::pi / sides);
  };
  EXPECT_NEAR(loop_length(mesh, shortest_crossing_loop(mesh, round_the_tube(mesh, 2), lengths), lengths),
              polygon(around, 12), 1e-9);
  EXPECT_NEAR(loop_length(mesh, shortest_crossing_loop(mesh, round_the_axis(mesh, 2), lengths), lengths),
              polygon(tube, 8), 1e-9);
}

TEST(ShortestCrossingLoop, NoneCrossesALoopThatBoundsADisk) {
  const Mesh mesh = build_mesh(torus_soup(around, tube));
  EdgeLoop round_a_face;
  for (int k = 0; k < 3; ++k) round_a_face.push_back(Mesh::halfedge(FaceId(0), k));
  EXPECT_THROW(shortest_crossing_loop(mesh, round_a_face, edge_lengths(mesh)), TopologyError);
}

TEST(ShortestLoop, IsTheShortestOfAllBasepoints) {
  const auto expect_shortest = [](const TriangleSoup& soup) {
    const Mesh mesh = build_mesh(soup), other = build_mesh(renumbered(soup, 11));
    const auto lengths = edge_lengths(mesh), other_lengths = edge_lengths(other);
    double best = std::numeric_limits<double>::infinity();
    for (VertexId v : mesh.vertices())
      best = std::min(best, loop_length(mesh, greedy_loops(mesh, v, lengths).loops.front(), lengths));
    const EdgeLoop found = shortest_loop(mesh, lengths, RunContext(2));
    EXPECT_NEAR(loop_length(mesh, found, lengths), best, 1e-9);
    EXPECT_NEAR(loop_length(other, shortest_loop(other, other_lengths, RunContext(1)), other_lengths), best,
                1e-9);
    std::vector<VertexId> met;
    for (HalfedgeId h : found) met.push_back(mesh.from(h));
    std::sort(met.begin(), met.end());
    EXPECT_EQ(std::adjacent_find(met.begin(), met.end()), met.end()) << "a vertex is met twice";
  };
  for (std::uint64_t seed : {1, 2}) {
    expect_shortest(bumpy_torus_soup(20, 10, seed));
    expect_shortest(bumpy_genus2_soup(12, 8, seed));
  }
}

TEST(ShortestLoop, ASphereHasNone) {
  const TriangleSoup tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                 {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
  const Mesh mesh = build_mesh(tetrahedron);
  EXPECT_THROW(shortest_loop(mesh, edge_lengths(mesh), RunContext(1)), TopologyError);
}

}  // namespace
}  // namespace foramen
