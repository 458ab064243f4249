#include "parameterize/periodic_laplacian.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "parameterize/mapped_torus.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

class AverageOfNeighbours : public ::testing::Test {
 protected:
  const testing::MappedTorus torus = testing::mapped_bumpy_torus(14, 9, 3);
  const Cocycle form{torus.map.jumps};
  VertexMap<Vec2> solved(const std::vector<std::pair<VertexId, Vec2>>& fixed) const {
    VertexMap<std::optional<Vec2>> places(torus.mesh.vertex_count());
    for (const auto& [v, place] : fixed) places[v] = place;
    return average_of_neighbours(torus.mesh, form, places);
  }
};

TEST_F(AverageOfNeighbours, PutsEveryVertexThereAndMovesWithTheFixedOne) {
  const VertexId fixed(5);
  const VertexMap<Vec2> here = solved({{fixed, Vec2(0.2, 0.3)}});
  const VertexMap<Vec2> there = solved({{fixed, Vec2(1.7, -0.4)}});
  EXPECT_EQ(here[fixed], Vec2(0.2, 0.3));
  for (VertexId v : torus.mesh.vertices()) {
    Vec2 pull = Vec2::Zero();
    for (HalfedgeId h : torus.mesh.fan(v))
      pull += here[torus.mesh.to(h)] + form.value[h].cast<double>() - here[v];
    // The pulls of all vertices cancel, so that the fixed one feels none either.
    EXPECT_LT(pull.norm(), 1e-10);
    EXPECT_LT((there[v] - here[v] - Vec2(1.5, -0.7)).norm(), 1e-10);
  }
  check_embedding(torus.mesh, {Lattice::Identity(), here, form.value});
}

TEST_F(AverageOfNeighbours, KeepsEveryFixedVertex) {
  const VertexMap<Vec2> places = solved({{VertexId(0), Vec2(0, 0)}, {VertexId(60), Vec2(0.45, 0.6)}});
  EXPECT_EQ(places[VertexId(0)], Vec2(0, 0));
  EXPECT_EQ(places[VertexId(60)], Vec2(0.45, 0.6));
}

TEST_F(AverageOfNeighbours, AFlippedTriangleOrATurnedTorusIsNoEmbedding) {
  TorusMap flipped = torus.map;
  flipped.turns[VertexId(3)] += Vec2(0.4, 0.3);
  EXPECT_THROW(check_embedding(torus.mesh, flipped), ConvergenceError);
  Eigen::Matrix2i swap;
  swap << 0, 1, 1, 0;
  EXPECT_THROW(check_embedding(torus.mesh, change_basis(torus.map, swap)), TopologyError);
}

}  // namespace
}  // namespace foramen
