#include "support/cut_open.hpp"

#include <gtest/gtest.h>

#include <set>

#include "foramen/core/error.hpp"
#include "support/real_meshes.hpp"
#include "topology/loop_fixtures.hpp"

namespace foramen {
namespace {

using namespace foramen::testing;

std::set<int> walked_edges(const Mesh& mesh, const LoopSystem& loops) {
  std::set<int> edges;
  for (const EdgeLoop& loop : loops.loops)
    for (HalfedgeId h : loop) edges.insert(mesh.edge(h).index);
  return edges;
}

std::size_t walked_length(const LoopSystem& loops) {
  std::size_t sum = 0;
  for (const EdgeLoop& loop : loops.loops) sum += loop.size();
  return sum;
}

void expect_one_disk(const Mesh& mesh, const LoopSystem& loops) {
  const CutMesh cut = testing::cut_open(mesh, loops);
  EXPECT_EQ(cut.disk.euler_characteristic(), 1);
  EXPECT_EQ(cut.disk.face_count(), mesh.face_count());
  ASSERT_EQ(cut.origin.size(), cut.disk.vertex_count());
  for (FaceId f : mesh.faces())
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(cut.origin[cut.disk.corners(f)[k]], mesh.corners(f)[k]);
      EXPECT_EQ(cut.disk.position(cut.disk.corners(f)[k]), mesh.position(mesh.corners(f)[k]));
    }
  // One closed boundary that takes each cut edge twice, once on either side, and nothing else.
  const auto edges = walked_edges(mesh, loops);
  EXPECT_EQ(cut.boundary.size(), 2 * edges.size());
  EXPECT_EQ(cut.disk.edge_count(), mesh.edge_count() + static_cast<int>(edges.size()));
  ASSERT_TRUE(is_closed_walk(cut.disk, cut.boundary));
  EXPECT_EQ(cut.origin[cut.disk.from(cut.boundary.front())], loops.basepoint);
  std::set<int> sides, vertices;
  for (HalfedgeId h : cut.boundary) {
    EXPECT_FALSE(cut.disk.twin(h).valid());
    EXPECT_TRUE(edges.contains(mesh.edge(h).index));
    sides.insert(h.index);
    vertices.insert(cut.disk.from(h).index);
  }
  EXPECT_EQ(sides.size(), cut.boundary.size());
  EXPECT_EQ(vertices.size(), cut.boundary.size());
}

TEST(CutOpen, LeavesOneDiskFromAnyBasepoint) {
  int shared = 0;
  for (const auto& [name, mesh, genus] : surfaces_with_handles()) {
    SCOPED_TRACE(name);
    for (VertexId basepoint : some_vertices(mesh, 25)) {
      const LoopSystem loops = greedy_loops(mesh, basepoint, edge_lengths(mesh));
      expect_one_disk(mesh, loops);
      if (walked_edges(mesh, loops).size() < walked_length(loops)) ++shared;
    }
  }
  EXPECT_GT(shared, 20) << "the meshes do not exercise shared edges";
}

TEST(CutOpen, LeavesOneDiskOfRealData) {
  FORAMEN_NEEDS_REAL_DATA();
  for (const char* stem : {"verse005_L1", "verse823_L4"}) {
    const Mesh mesh = real_mesh(std::string("lumbar/") + stem);
    for (VertexId basepoint : some_vertices(mesh, 4))
      expect_one_disk(mesh, greedy_loops(mesh, basepoint, edge_lengths(mesh)));
  }
}

class CutTorus : public ::testing::Test {
 protected:
  static constexpr int around = 12, tube = 8;
  const Mesh mesh = build_mesh(torus_soup(around, tube));
  LoopSystem with(std::vector<EdgeLoop> loops) const {
    LoopSystem system;
    system.basepoint = mesh.from(loops.front().front());
    system.loops = std::move(loops);
    return system;
  }
  const EdgeLoop m = tube_loop(mesh, tube), e = rim_loop(mesh, around, tube);
};

TEST_F(CutTorus, AlongTwoLoopsThatMeetOnce) {
  const LoopSystem loops = with({m, e});
  expect_one_disk(mesh, loops);
  const CutMesh cut = testing::cut_open(mesh, loops);
  EXPECT_EQ(cut.boundary.size(), 2 * (around + tube));                          // a rectangle
  EXPECT_EQ(cut.disk.vertex_count(), mesh.vertex_count() + around + tube + 1);  // four copies of the corner
}

TEST_F(CutTorus, AlongAThetaGraph) {
  EdgeLoop both = m;  // the second loop walks all of the first before its own way: m and m e share m
  both.insert(both.end(), e.begin(), e.end());
  expect_one_disk(mesh, with({m, both}));
  EdgeLoop detour =
      e;  // leaves the rim for the next row and returns: shares one edge with m and most edges with e
  const VertexId rim = mesh.from(e[0]), up = mesh.to(m[0]);
  detour = {m[0]};
  for (int i = 0; i < around; ++i)
    detour.push_back(mesh.find_halfedge(VertexId((i * tube) + up.index % tube),
                                        VertexId(((i + 1) % around) * tube + up.index % tube)));
  detour.push_back(mesh.find_halfedge(up, rim));
  ASSERT_TRUE(is_closed_walk(mesh, detour));
  expect_one_disk(mesh, with({m, detour}));
}

TEST_F(CutTorus, AlongLoopsWithASpur) {
  const VertexId far(3 * tube + 1);  // a basepoint off both loops, which therefore share a path to it
  const auto paths = shortest_paths(mesh, far, edge_lengths(mesh));
  const auto tail = path_to(mesh, paths, mesh.from(m[0]));
  ASSERT_GT(tail.size(), 1u);
  std::vector<EdgeLoop> loops;
  for (const EdgeLoop& loop : {m, e}) {
    EdgeLoop walked = tail;
    walked.insert(walked.end(), loop.begin(), loop.end());
    for (auto h = tail.rbegin(); h != tail.rend(); ++h) walked.push_back(mesh.twin(*h));
    ASSERT_TRUE(is_closed_walk(mesh, walked));
    loops.push_back(walked);
  }
  expect_one_disk(mesh, with(loops));
}

TEST_F(CutTorus, RefusesLoopsThatDoNotGenerate) {
  EXPECT_THROW(testing::cut_open(mesh, with({m})), TopologyError);  // an annulus is left
  EXPECT_THROW(testing::cut_open(mesh, with({m, m})), TopologyError);
  const FaceId f(40);
  const EdgeLoop round{Mesh::halfedge(f, 0), Mesh::halfedge(f, 1), Mesh::halfedge(f, 2)};
  EXPECT_THROW(testing::cut_open(mesh, with({m, e, round})), TopologyError);  // two pieces
  EXPECT_THROW(testing::cut_open(mesh, LoopSystem{VertexId(0), {}, {}, {}, 0}),
               TopologyError);  // nothing is cut
  LoopSystem elsewhere = with({m, e});
  elsewhere.basepoint = VertexId(2 * tube);
  EXPECT_THROW(testing::cut_open(mesh, elsewhere), TopologyError);
}

}  // namespace
}  // namespace foramen
