#include "foramen/parameterize/torus_map.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "parameterize/mapped_torus.hpp"

namespace foramen {
namespace {

using testing::mapped_bumpy_torus;

Vec2 edge_in_plane(const Mesh& mesh, const TorusMap& map, HalfedgeId h) {
  return map.lattice * (map.turns[mesh.to(h)] + map.jumps[h].cast<double>() - map.turns[mesh.from(h)]);
}

TEST(Wrap, StaysBelowOneAndDiffersByWholeTurns) {
  EXPECT_EQ(wrap(-1e-17), 0.0);
  EXPECT_EQ(wrap(1.0), 0.0);
  EXPECT_EQ(wrap(-2.0), 0.0);
  Rng rng(1);
  for (int k = 0; k < 1000; ++k) {
    const double t = rng.uniform(-5, 5), w = wrap(t);
    EXPECT_GE(w, 0.0);
    EXPECT_LT(w, 1.0);
    EXPECT_NEAR(t - w, std::round(t - w), 1e-14);
    EXPECT_EQ(wrap(w), w);
  }
}

TEST(LatticeReducer, FindsTheShortestOfManyTranslates) {
  Rng rng(2);
  for (int k = 0; k < 200; ++k) {
    Lattice lattice;
    lattice << rng.uniform(0.4, 2), rng.uniform(-3, 3), 0, rng.uniform(0.4, 2);
    const LatticeReducer reducer(lattice);
    for (int i = 0; i < 5; ++i) {
      const Vec2 v = lattice * Vec2(rng.uniform(-1, 1), rng.uniform(-1, 1));
      double best = v.norm();
      for (int a = -20; a <= 20; ++a)
        for (int b = -20; b <= 20; ++b) best = std::min(best, (v + lattice * Vec2(a, b)).norm());
      const Vec2 found = reducer.shortest(v);
      EXPECT_NEAR(found.norm(), best, 1e-12);
      const Vec2 turns = lattice.inverse() * (found - v);
      EXPECT_NEAR((turns - Vec2(turns.array().round())).norm(), 0, 1e-11);
    }
  }
}

TEST(LatticeReducer, EndsOnALatticeWithoutShorterVectors) {
  Lattice hexagonal;
  hexagonal << 1, 0.5, 0, std::sqrt(0.75);
  EXPECT_NEAR(LatticeReducer(hexagonal).shortest(hexagonal * Vec2(3.4, -2.3)).norm(),
              (hexagonal * Vec2(0.4, -0.3)).norm(), 1e-12);
}

TEST(TorusMap, WrappingKeepsEveryEdge) {
  auto [mesh, map] = mapped_bumpy_torus(12, 9, 1);
  map.lattice << 1.2, 0.3, 0, 1 / 1.2;
  Rng rng(3);
  for (VertexId v : mesh.vertices()) {  // the same map, with points translated by many turns
    const Vec2i whole(rng.below(7) - 3, rng.below(7) - 3);
    map.turns[v] += whole.cast<double>();
    for (HalfedgeId h : mesh.fan(v)) {
      map.jumps[h] += whole;
      map.jumps[mesh.twin(h)] -= whole;
    }
  }
  const TorusMap inside = wrapped(mesh, map);
  for (VertexId v : mesh.vertices()) {
    EXPECT_GE(inside.turns[v].minCoeff(), 0.0);
    EXPECT_LT(inside.turns[v].maxCoeff(), 1.0);
  }
  for (HalfedgeId h : mesh.halfedges()) {
    EXPECT_NEAR((edge_in_plane(mesh, inside, h) - edge_in_plane(mesh, map, h)).norm(), 0, 1e-14);
    EXPECT_EQ(inside.jumps[mesh.twin(h)], -inside.jumps[h]);
  }
}

TEST(TorusMap, PlaneTriangleHasTheEdgesAndTheArea) {
  auto [mesh, map] = mapped_bumpy_torus(12, 9, 2);
  map.lattice << 0.8, -0.4, 0, 1.25;
  double sum = 0;
  for (FaceId f : mesh.faces()) {
    const auto t = plane_triangle(mesh, map, f);
    for (int k = 0; k < 3; ++k) {
      const Vec2 side = t[(k + 1) % 3] - t[k];
      EXPECT_NEAR((side - edge_in_plane(mesh, map, Mesh::halfedge(f, k))).norm(), 0, 1e-14);
    }
    sum += signed_area(mesh, map, f);
  }
  EXPECT_NEAR(sum, map.lattice.determinant(), 1e-12);
}

TEST(TorusMap, QuantisedPositionsAreMultiplesAndNear) {
  const auto [mesh, map] = mapped_bumpy_torus(12, 9, 3);
  const TorusMap q = quantised(mesh, map);
  for (VertexId v : mesh.vertices())
    for (int k = 0; k < 2; ++k) {
      const double quanta = std::ldexp(q.turns[v][k], quantum_bits);
      EXPECT_EQ(quanta, std::round(quanta));
      EXPECT_LE(std::abs(q.turns[v][k] - map.turns[v][k]), std::ldexp(0.5, -quantum_bits));
    }
  EXPECT_EQ(quantised(mesh, q).turns, q.turns);
}

TEST(ChangeBasis, IsTheSameMapUpToAMotionOfThePlane) {
  auto [mesh, map] = mapped_bumpy_torus(12, 9, 4);
  map.lattice << 1.2, 0.3, 0, 1 / 1.2;
  for (const auto& entries :
       {std::array{1, 1, 0, 1}, {0, 1, -1, 0}, {-1, 0, 0, -1}, {2, 1, 1, 1}, {0, 1, 1, 0}}) {
    Eigen::Matrix2i b;
    b << entries[0], entries[1], entries[2], entries[3];
    const int det = entries[0] * entries[3] - entries[1] * entries[2];
    const TorusMap changed = change_basis(map, b);
    EXPECT_EQ(changed.lattice(1, 0), 0);
    EXPECT_GT(changed.lattice(0, 0), 0);
    EXPECT_NEAR(changed.lattice.determinant(), 1, 1e-12);
    for (HalfedgeId h : mesh.halfedges())
      EXPECT_NEAR(edge_in_plane(mesh, changed, h).norm(), edge_in_plane(mesh, map, h).norm(), 1e-12);
    for (FaceId f : mesh.faces())
      EXPECT_NEAR(signed_area(mesh, changed, f), det * signed_area(mesh, map, f), 1e-13);
  }
  Eigen::Matrix2i twice;
  twice << 2, 0, 0, 1;
  EXPECT_THROW(change_basis(map, twice), InvalidInput);
}

}  // namespace
}  // namespace foramen
