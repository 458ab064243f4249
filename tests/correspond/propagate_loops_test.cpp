#include "correspond/propagate_loops.hpp"

#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "support/meshes.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

using testing::bumpy_torus_soup;
using testing::renumbered;

double smallest_distance(const Vec3& p, const ReferenceLoops& reference) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const EdgeLoop& loop : reference.loops.loops)
    for (HalfedgeId h : loop)
      smallest = std::min(smallest, (p - reference.mesh.position(reference.mesh.from(h))).norm());
  return smallest;
}

TEST(PropagateLoops, EdgeCostIsEquation3) {
  const ReferenceLoops reference =
      find_reference_loops(build_mesh(bumpy_torus_soup(16, 9, 1)), RunContext(1));
  const Mesh shape = build_mesh(bumpy_torus_soup(14, 8, 2));
  const auto paper = loop_edge_costs(shape, reference, EdgeCost::paper);
  const auto weighted = loop_edge_costs(shape, reference, EdgeCost::length_weighted);
  for (EdgeId e : shape.edges()) {
    const HalfedgeId h = shape.halfedge(e);
    const double mean = 0.5 * (smallest_distance(shape.position(shape.from(h)), reference) +
                               smallest_distance(shape.position(shape.to(h)), reference));
    EXPECT_NEAR(paper[e], mean, 1e-12);
    EXPECT_NEAR(weighted[e], (mean + 0.5) * edge_length(shape, e), 1e-12);
  }
}

TEST(PropagateLoops, OntoItselfTheLoopsAreTheReferences) {
  const Mesh mesh = build_mesh(bumpy_torus_soup(18, 10, 3));
  const ReferenceLoops reference = find_reference_loops(mesh, RunContext(1));
  const auto lengths = edge_lengths(mesh);
  for (EdgeCost cost : {EdgeCost::paper, EdgeCost::length_weighted}) {
    const LoopSystem loops = propagate_loops(mesh, reference, cost);
    EXPECT_EQ(loops.basepoint, reference.loops.basepoint);
    // The cost on the loops is almost zero, so the loops that are found must run along them.
    for (const EdgeLoop& loop : loops.loops)
      for (HalfedgeId h : loop) EXPECT_LT(smallest_distance(mesh.position(mesh.from(h)), reference), 1e-12);
  }
}

TEST(PropagateLoops, OrientedSystemsCrossThePositiveWay) {
  for (int seed = 0; seed < 8; ++seed) {
    const Mesh mesh = build_mesh(renumbered(bumpy_torus_soup(12, 8, 4), static_cast<std::uint64_t>(seed)));
    const LoopSystem loops = oriented(mesh, greedy_loops(mesh, VertexId(seed), edge_lengths(mesh)));
    const Cocycle form = cocycle(mesh, loops);
    int doubled_area = 0;
    for (FaceId f : mesh.faces()) {
      const Vec2i a = form.value[Mesh::halfedge(f, 0)], b = form.value[Mesh::halfedge(f, 1)];
      doubled_area += a.x() * b.y() - a.y() * b.x();
    }
    EXPECT_EQ(doubled_area, 2);
    for (int k = 0; k < 2; ++k) {
      Vec2i unit = Vec2i::Zero();
      unit[k] = 1;
      EXPECT_EQ(integrate(form, loops.loops[k]), unit);
    }
  }
}

}  // namespace
}  // namespace foramen
