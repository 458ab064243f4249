#include "correspond/vertex_path.hpp"

#include <limits>

#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

// The oracle: distances from one vertex, relaxed over all edges until none changes.
VertexMap<double> distances_from(VertexId source, const Mesh& mesh, const EdgeMap<double>& lengths) {
  VertexMap<double> distance(mesh.vertex_count(), std::numeric_limits<double>::infinity());
  distance[source] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (HalfedgeId h : mesh.halfedges()) {
      const double through = distance[mesh.from(h)] + lengths[mesh.edge(h)];
      if (through < distance[mesh.to(h)]) distance[mesh.to(h)] = through, changed = true;
    }
  }
  return distance;
}

TEST(VertexPaths, AreWalksAsLongAsTheDistanceBetweenAnyTwoVertices) {
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(10, 7, 4));
  const EdgeMap<double> lengths = edge_lengths(mesh);
  VertexPaths paths(mesh, lengths);  // one for all queries: nothing of one may be left for the next
  for (VertexId a : mesh.vertices()) {
    const VertexMap<double> distance = distances_from(a, mesh, lengths);
    for (VertexId b : mesh.vertices()) {
      VertexId at = a;
      double length = 0;
      for (const HalfedgeId h : paths.between(a, b)) {
        ASSERT_EQ(mesh.from(h), at);
        at = mesh.to(h);
        length += lengths[mesh.edge(h)];
      }
      ASSERT_EQ(at, b);
      EXPECT_NEAR(length, distance[b], 1e-12 * (1 + distance[b]));
    }
  }
}

}  // namespace
}  // namespace foramen
