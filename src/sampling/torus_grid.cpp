#include "sampling/torus_grid.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// With fewer rows or columns two edges would join the same two points.
constexpr int fewest_a_side = 3;

/// A grid point that may lie one period beyond the last row or column.
struct GridPlace {
  int index;
  Vec2i period;
};

void add_triangle(TorusGrid& grid, std::vector<Vec2i>& jumps, const std::array<GridPlace, 3>& corners) {
  grid.triangles.push_back({corners[0].index, corners[1].index, corners[2].index});
  for (std::size_t k = 0; k < 3; ++k) jumps.push_back(corners[(k + 1) % 3].period - corners[k].period);
}

}  // namespace

TorusGrid make_torus_grid(const Lattice& lattice, int points) {
  if (!(lattice.determinant() > 0)) throw InvalidInput("torus grid: the lattice has no positive area");
  if (points < fewest_a_side * fewest_a_side)
    throw InvalidInput("torus grid: needs at least 9 points, asked for " + std::to_string(points));
  const double ratio = lattice.col(0).norm() / lattice.col(1).norm();
  TorusGrid grid;
  grid.columns = std::clamp(static_cast<int>(std::lround(std::sqrt(points * ratio))), fewest_a_side,
                            points / fewest_a_side);
  grid.rows = std::max(fewest_a_side, static_cast<int>(std::lround(double(points) / grid.columns)));
  grid.turns.reserve(static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns));
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c)
      grid.turns.emplace_back(double(c) / grid.columns, double(r) / grid.rows);

  const auto place = [&](int r, int c) {
    const Vec2i period(c / grid.columns, r / grid.rows);
    return GridPlace{r % grid.rows * grid.columns + c % grid.columns, period};
  };
  const Vec2 across = lattice.col(0) / grid.columns, up = lattice.col(1) / grid.rows;
  const bool rising = (across + up).squaredNorm() <= (up - across).squaredNorm();
  std::vector<Vec2i> jumps;
  jumps.reserve(6 * grid.turns.size());
  grid.triangles.reserve(2 * grid.turns.size());
  for (int r = 0; r < grid.rows; ++r)
    for (int c = 0; c < grid.columns; ++c) {
      const GridPlace p00 = place(r, c), p10 = place(r, c + 1), p01 = place(r + 1, c),
                      p11 = place(r + 1, c + 1);
      add_triangle(grid, jumps, rising ? std::array{p00, p10, p11} : std::array{p00, p10, p01});
      add_triangle(grid, jumps, rising ? std::array{p00, p11, p01} : std::array{p10, p11, p01});
    }
  grid.jumps = HalfedgeMap<Vec2i>(std::move(jumps));
  return grid;
}

}  // namespace foramen
