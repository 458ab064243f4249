#include "correspond/soft_neighbours.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using testing::bumpy_torus_soup;

// The torus positions of the reference are arbitrary here, because the term only reads them.
struct Scene {
  Mesh reference = build_mesh(bumpy_torus_soup(12, 8, 1));
  Mesh shape = build_mesh(bumpy_torus_soup(10, 7, 2));
  TorusMap map;
  Scene() {
    Rng rng(3);
    map.lattice << 1.25, 0.3, 0, 0.8;
    map.turns = VertexMap<Vec2>(reference.vertex_count(), Vec2::Zero());
    for (Vec2& p : map.turns) p = Vec2(rng.uniform(), rng.uniform());
  }
};

// Equation 4, computed directly from its definition.
double equation4(const Scene& scene, VertexId j, const Vec2& x, int q, double eps) {
  const Vec3& p = scene.shape.position(j);
  std::vector<std::pair<double, int>> all;
  for (VertexId k : scene.reference.vertices())
    all.emplace_back((scene.reference.position(k) - p).norm(), k.index);
  std::sort(all.begin(), all.end());
  double sum = 0;
  for (int n = 0; n < q; ++n) {
    const Vec2 target = scene.map.turns[VertexId(all[n].second)];
    double shortest = std::numeric_limits<double>::infinity();
    for (int a = -4; a <= 4; ++a)
      for (int b = -4; b <= 4; ++b)
        shortest = std::min(shortest, (x - scene.map.lattice * (target + Vec2(a, b))).squaredNorm());
    sum += std::exp(-all[n].first) * std::sqrt(shortest + eps * eps);
  }
  return sum;
}

TEST(SoftNeighbours, IsEquation4) {
  const Scene scene;
  const SoftNeighbours term(scene.shape, scene.reference, scene.map,
                            {.search = NeighbourSearch::points, .weights = NeighbourWeights::absolute});
  Rng rng(4);
  for (VertexId v : scene.shape.vertices()) {
    const Vec2 x(rng.uniform(-2, 2), rng.uniform(-2, 2));
    EXPECT_NEAR(term.term(v, x).value, equation4(scene, v, x, 8, 1e-3), 1e-12);
  }
}

TEST(SoftNeighbours, GradientAndHessianAreDifferences) {
  const Scene scene;
  const SoftNeighbours term(scene.shape, scene.reference, scene.map, {.smoothing = 0.05});
  Rng rng(5);
  const double h = 1e-5;
  for (int i = 0; i < 50; ++i) {
    const VertexId v(rng.below(scene.shape.vertex_count()));
    const Vec2 x(rng.uniform(), rng.uniform());
    const auto at = term.term(v, x);
    for (int c = 0; c < 2; ++c) {
      Vec2 step = Vec2::Zero();
      step[c] = h;
      const auto up = term.term(v, x + step), down = term.term(v, x - step);
      EXPECT_NEAR((up.value - down.value) / (2 * h), at.gradient[c], 1e-6);
      EXPECT_LT((at.hessian.col(c) - (up.gradient - down.gradient) / (2 * h)).norm(), 1e-4);
    }
    EXPECT_GE(at.hessian.determinant(), 0);
  }
}

TEST(SoftNeighbours, IsPeriodicAndRelativeWeightsSumToOne) {
  const Scene scene;
  const double far_apart =
      1e4;  // all neighbours then have the same distance, so the value gives the sum of weights
  const SoftNeighbours term(scene.shape, scene.reference, scene.map, {.smoothing = far_apart});
  const SoftNeighbours sharp(scene.shape, scene.reference, scene.map);
  for (VertexId v : scene.shape.vertices()) {
    EXPECT_NEAR(term.term(v, Vec2(0.2, 0.3)).value / far_apart, 1, 1e-6);
    const Vec2 x(0.1, 0.7), moved = x + scene.map.lattice * Vec2(2, -3);
    EXPECT_NEAR(sharp.term(v, x).value, sharp.term(v, moved).value, 1e-12);
  }
}

TEST(SoftNeighbours, OrientedSearchStaysOnItsSideOfAThinWall) {
  // Two sheets 1 mm apart that face away from each other, each a patch of a torus-like grid: a query just
  // inside the upper sheet is nearer to the lower one, but faces like the upper.
  TriangleSoup wall;
  for (double z : {0.0, 1.0})
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) wall.points.emplace_back(i, j, z);
  for (int sheet = 0; sheet < 2; ++sheet)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const int a = 16 * sheet + 4 * i + j;
        std::array<int, 3> first{a, a + 4, a + 5}, second{a, a + 5, a + 1};
        if (sheet == 0) {
          std::swap(first[1], first[2]);
          std::swap(second[1], second[2]);
        }
        wall.triangles.push_back(first);
        wall.triangles.push_back(second);
      }
  const Mesh reference = build_mesh(wall);
  TorusMap map;
  map.turns = VertexMap<Vec2>(32, Vec2::Zero());
  for (int v = 16; v < 32; ++v) map.turns[VertexId(v)] = Vec2(0.5, 0.0);
  std::vector<Vec3> moved(wall.points.begin(), wall.points.end());
  for (Vec3& p : moved)
    p.z() = p.z() > 0.5 ? 0.4 : -0.6;  // the upper sheet is now nearer to the reference's lower one
  const Mesh shape = reference.with_positions(moved);
  const VertexId inner(16 + 5);
  const Vec2 upper(0.5, 0.0);
  const SoftNeighbours blind(shape, reference, map, {.count = 1, .search = NeighbourSearch::points});
  const SoftNeighbours oriented(shape, reference, map, {.count = 1});
  EXPECT_GT(blind.term(inner, upper).value, 0.4);
  EXPECT_LT(oriented.term(inner, upper).value, 0.01);
}

}  // namespace
}  // namespace foramen
