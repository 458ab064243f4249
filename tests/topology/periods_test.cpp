#include "topology/periods.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/real_meshes.hpp"
#include "topology/loop_fixtures.hpp"

namespace foramen {
namespace {

using namespace foramen::testing;

TEST(Cocycle, IsClosedAndHasUnitPeriods) {
  for (const auto& [name, mesh, genus] : surfaces_with_handles()) {
    if (genus != 1) continue;
    SCOPED_TRACE(name);
    for (VertexId basepoint : some_vertices(mesh, 15)) {
      const LoopSystem loops = greedy_loops(mesh, basepoint, edge_lengths(mesh));
      const Cocycle form = cocycle(mesh, loops);
      EXPECT_TRUE(is_closed_form(mesh, form));
      EXPECT_EQ(integrate(form, loops.loops[0]), Vec2i::UnitX());
      EXPECT_EQ(integrate(form, loops.loops[1]), Vec2i::UnitY());
    }
  }
}

TEST(Cocycle, SeesHomologyOnly) {
  const int around = 16, tube = 10;
  const Mesh mesh = build_mesh(torus_soup(around, tube));
  const Cocycle form = cocycle(mesh, greedy_loops(mesh, VertexId(31), edge_lengths(mesh)));
  const Vec2i m = integrate(form, tube_loop(mesh, tube)), e = integrate(form, rim_loop(mesh, around, tube));
  EXPECT_EQ(std::abs(m.x() * e.y() - m.y() * e.x()), 1);
  for (int shift = 0; shift < around; ++shift) {  // loops at all positions along the axis have the same class
    std::vector<int> vertices;
    for (int j = 0; j < tube; ++j) vertices.push_back(shift * tube + j);
    EXPECT_EQ(integrate(form, walk_through(mesh, vertices)), m);
  }
  for (FaceId f : mesh.faces()) {  // the border of a face has no period
    const EdgeLoop round{Mesh::halfedge(f, 0), Mesh::halfedge(f, 1), Mesh::halfedge(f, 2)};
    EXPECT_EQ(integrate(form, round), Vec2i::Zero());
  }
}

// For two bases of one surface, each form gives a change of basis on the loops of the other. These two are
// inverse to each other.
TEST(Cocycle, ChangesOfBasisAreInverse) {
  const Mesh mesh = build_mesh(bumpy_torus_soup(20, 14, 3));
  const auto lengths = edge_lengths(mesh);
  const LoopSystem here = greedy_loops(mesh, VertexId(0), lengths);
  const auto periods = [](const Cocycle& form, const LoopSystem& loops) {
    Eigen::Matrix2i a;
    for (int k = 0; k < 2; ++k) a.col(k) = integrate(form, loops.loops[k]);
    return a;
  };
  for (VertexId v : some_vertices(mesh, 20)) {
    const LoopSystem there = greedy_loops(mesh, v, lengths);
    const Eigen::Matrix2i a = periods(cocycle(mesh, here), there), b = periods(cocycle(mesh, there), here);
    EXPECT_EQ(Eigen::Matrix2i(a * b), Eigen::Matrix2i(Eigen::Matrix2i::Identity()));
  }
}

TEST(Cocycle, HasUnitPeriodsOnRealData) {
  FORAMEN_NEEDS_REAL_DATA();
  const Mesh mesh = real_mesh("lumbar/verse631_L5");
  for (VertexId v : some_vertices(mesh, 5)) {
    const LoopSystem loops = greedy_loops(mesh, v, edge_lengths(mesh));
    const Cocycle form = cocycle(mesh, loops);
    EXPECT_TRUE(is_closed_form(mesh, form));
    EXPECT_EQ(integrate(form, loops.loops[0]), Vec2i::UnitX());
    EXPECT_EQ(integrate(form, loops.loops[1]), Vec2i::UnitY());
  }
}

TEST(Cocycle, BreakOneValueAndItIsNotClosed) {
  const Mesh mesh = build_mesh(torus_soup(8, 6));
  const Cocycle form = cocycle(mesh, greedy_loops(mesh, VertexId(0), edge_lengths(mesh)));
  const HalfedgeId h(10);
  Cocycle one_side = form;
  one_side.value[h] += Vec2i(1, 0);
  EXPECT_FALSE(is_closed_form(mesh, one_side));
  Cocycle both_sides = form;
  both_sides.value[h] += Vec2i(0, 1);
  both_sides.value[mesh.twin(h)] -= Vec2i(0, 1);
  EXPECT_FALSE(is_closed_form(mesh, both_sides));
  Cocycle short_of_one = form;
  short_of_one.value.values().pop_back();
  EXPECT_FALSE(is_closed_form(mesh, short_of_one));
}

TEST(Cocycle, NeedsGenusOne) {
  const Mesh mesh = build_mesh(genus2_soup(10, 8));
  EXPECT_THROW(cocycle(mesh, greedy_loops(mesh, VertexId(0), edge_lengths(mesh))), TopologyError);
}

}  // namespace
}  // namespace foramen
