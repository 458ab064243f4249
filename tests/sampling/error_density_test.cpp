#include "sampling/error_density.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/mapped_tori.hpp"
#include "sampling/torus_grid.hpp"

namespace foramen {
namespace {

/// A shape and its grid. The landmarks are the vertices of a torus. The shape is this torus with one vertex
/// moved outward.
class ErrorDensity : public ::testing::Test {
 protected:
  static constexpr double height_mm = 2;
  const testing::MappedSurface torus = testing::torus(3000);
  const TorusGrid grid = make_torus_grid(torus.map.lattice, 2000);
  const VertexMap<double> density = uneven_density();
  const RunContext ctx{1};

  VertexMap<double> uneven_density() const {
    VertexMap<double> values(grid.rows * grid.columns, 0.0);
    for (std::size_t k = 0; k < grid.turns.size(); ++k)
      values.values()[k] = 1 + 0.5 * std::sin(7 * grid.turns[k].x()) * std::cos(4 * grid.turns[k].y());
    return values;
  }
  std::vector<Vec3> landmarks() const {
    return {torus.mesh.positions().begin(), torus.mesh.positions().end()};
  }
  std::vector<std::array<int, 3>> triangles() const {
    std::vector<std::array<int, 3>> all;
    for (FaceId f : torus.mesh.faces()) {
      const auto c = torus.mesh.corners(f);
      all.push_back({c[0].index, c[1].index, c[2].index});
    }
    return all;
  }
  /// The vertex next to these turns on the outer equator, where the torus is convex.
  VertexId on_equator(double turns) const {
    VertexId best(0);
    for (VertexId v : torus.mesh.vertices())
      if (distance(torus.map.turns[v], {turns, 0}) < distance(torus.map.turns[best], {turns, 0})) best = v;
    return best;
  }
  Mesh with_spike(VertexId v, double height) const {
    std::vector<Vec3> positions = landmarks();
    Vec3& p = positions[v.index];
    p += height * p.normalized();
    return torus.mesh.with_positions(std::move(positions));
  }
  VertexMap<double> raised(const std::vector<RepresentedShape>& shapes,
                           const ErrorDensityOptions& options = {}) const {
    return raised_by_error(density, grid, shapes, triangles(), ctx, options);
  }
  /// The distance of two torus positions, in turns.
  static double distance(const Vec2& a, const Vec2& b) {
    return std::hypot(std::remainder(a.x() - b.x(), 1.0), std::remainder(a.y() - b.y(), 1.0));
  }
  /// The number of steps between two points along rows and columns of the grid, round the torus.
  int steps(int point, int other) const {
    const auto around = [](int a, int b, int count) {
      const int d = std::abs(a - b);
      return std::min(d, count - d);
    };
    return around(point / grid.columns, other / grid.columns, grid.rows) +
           around(point % grid.columns, other % grid.columns, grid.columns);
  }
  int nearest(const Vec2& turns) const {
    const int row = static_cast<int>(std::lround(turns.y() * grid.rows)) % grid.rows;
    const int column = static_cast<int>(std::lround(turns.x() * grid.columns)) % grid.columns;
    return row * grid.columns + column;
  }
};

TEST_F(ErrorDensity, ErrorsThatAreAcceptedChangeNothing) {
  EXPECT_EQ(raised({{&torus.mesh, &torus.map.turns, landmarks()}}), density);
  const Mesh low = with_spike(on_equator(0.3), 0.3);
  EXPECT_EQ(raised({{&low, &torus.map.turns, landmarks()}}, {.accepted_mm = 0.31}), density);
  EXPECT_NE(raised({{&low, &torus.map.turns, landmarks()}}, {.accepted_mm = 0.29}), density);
  EXPECT_EQ(raised({{&low, &torus.map.turns, landmarks()}}, {.accepted_mm = 0.1, .exponent = 0}), density);
  EXPECT_EQ(raised({}), density);
}

TEST_F(ErrorDensity, AnErrorRaisesItThereByItsPowerAndNowhereFar) {
  const VertexId spike = on_equator(0.3);
  const Mesh shape = with_spike(spike, height_mm);
  const int place = nearest(torus.map.turns[spike]);
  constexpr int smoothing_reach = 3;
  for (const double exponent : {1.0, 1.5}) {
    const ErrorDensityOptions options{.accepted_mm = 0.5, .exponent = exponent, .spread_rings = 3};
    const VertexMap<double> result = raised({{&shape, &torus.map.turns, landmarks()}}, options);
    EXPECT_NEAR(result.values()[place] / density.values()[place], std::pow(height_mm / 0.5, exponent), 1e-9);
    for (int k = 0; k < density.size(); ++k) {
      const double factor = result.values()[k] / density.values()[k];
      EXPECT_GE(factor, 1);
      if (steps(k, place) > options.spread_rings + smoothing_reach) {
        EXPECT_EQ(factor, 1);
      } else if (steps(k, place) == options.spread_rings) {
        EXPECT_GT(factor, 1.5);
      }
    }
  }
}

TEST_F(ErrorDensity, GoesRoundTheTorus) {
  const VertexId spike = on_equator(0);
  ASSERT_EQ(torus.map.turns[spike], Vec2::Zero());
  const Mesh shape = with_spike(spike, height_mm);
  const VertexMap<double> result = raised({{&shape, &torus.map.turns, landmarks()}});
  const auto factor = [&](int row, int column) {
    const int k = row * grid.columns + column;
    return result.values()[k] / density.values()[k];
  };
  for (int k = 1; k <= 4; ++k) {
    EXPECT_GT(factor(0, k), 1);
    EXPECT_NEAR(factor(0, k), factor(0, grid.columns - k), 1e-12);
    EXPECT_NEAR(factor(k, 0), factor(grid.rows - k, 0), 1e-12);
    EXPECT_NEAR(factor(k, k), factor(grid.rows - k, grid.columns - k), 1e-12);
  }
  // A position just below a whole turn belongs to the point at 0, whatever number of whole turns is added.
  VertexMap<Vec2> turns = torus.map.turns;
  turns[spike] = Vec2(1 - 1e-9, 1 - 1e-9);
  EXPECT_EQ(raised({{&shape, &turns, landmarks()}}), result);
  turns[spike] = Vec2(3, -2);
  EXPECT_EQ(raised({{&shape, &turns, landmarks()}}), result);
}

TEST_F(ErrorDensity, TheWorstShapeCountsAndThreadsChangeNothing) {
  const Mesh low = with_spike(on_equator(0.3), 1), high = with_spike(on_equator(0.3), height_mm);
  const Mesh elsewhere = with_spike(on_equator(0.7), height_mm);
  const RepresentedShape a{&low, &torus.map.turns, landmarks()}, b{&high, &torus.map.turns, landmarks()};
  const RepresentedShape c{&elsewhere, &torus.map.turns, landmarks()};
  EXPECT_EQ(raised({a, b}), raised({b}));
  EXPECT_EQ(raised({b, a, b}), raised({b}));
  const std::vector<RepresentedShape> all{a, b, c};
  EXPECT_EQ(raised_by_error(density, grid, all, triangles(), RunContext(2)), raised(all));
  const VertexMap<double> both = raised(all), one = raised({b}), other = raised({c});
  for (int k = 0; k < density.size(); ++k)
    EXPECT_EQ(both.values()[k], std::max(one.values()[k], other.values()[k]));
}

TEST_F(ErrorDensity, RefusesOptionsOutOfRange) {
  EXPECT_THROW(raised({}, {.accepted_mm = 0}), InvalidInput);
  EXPECT_THROW(raised({}, {.exponent = -1}), InvalidInput);
  EXPECT_THROW(raised({}, {.spread_rings = -1}), InvalidInput);
}

}  // namespace
}  // namespace foramen
