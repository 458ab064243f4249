#include "sampling/error_density.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

constexpr int smoothing_rounds = 3;

/// The neighbourhoods of the grid points: the next points in row and column, periodically.
class GridNeighbours {
 public:
  explicit GridNeighbours(const TorusGrid& grid) : rows_(grid.rows), columns_(grid.columns) {}
  int nearest(const Vec2& turns) const {
    return index(static_cast<int>(std::lround(wrap(turns.y()) * rows_)),
                 static_cast<int>(std::lround(wrap(turns.x()) * columns_)));
  }
  template <class Combine>
  std::vector<double> filtered(const std::vector<double>& values, const Combine& combine) const {
    std::vector<double> out(values.size());
    for (int r = 0; r < rows_; ++r)
      for (int c = 0; c < columns_; ++c) {
        const std::array<double, 5> ring{values[index(r, c)], values[index(r + 1, c)],
                                         values[index(r + rows_ - 1, c)], values[index(r, c + 1)],
                                         values[index(r, c + columns_ - 1)]};
        out[index(r, c)] = combine(ring);
      }
    return out;
  }

 private:
  int index(int row, int column) const { return (row % rows_) * columns_ + column % columns_; }
  int rows_, columns_;
};

// For each grid point, the largest error of the shape's vertices that are nearest to it.
std::vector<double> errors_on_grid(const RepresentedShape& shape, const GridNeighbours& grid,
                                   std::size_t points, const std::vector<std::array<int, 3>>& triangles) {
  const TriangleTree sampled(build_mesh({shape.landmarks, triangles}));
  std::vector<double> errors(points, 0.0);
  for (VertexId v : shape.input->vertices()) {
    double& error = errors[grid.nearest((*shape.turns)[v])];
    error = std::max(error, std::sqrt(sampled.closest(shape.input->position(v)).squared_distance));
  }
  return errors;
}

}  // namespace

VertexMap<double> raised_by_error(const VertexMap<double>& density, const TorusGrid& grid,
                                  std::span<const RepresentedShape> shapes,
                                  const std::vector<std::array<int, 3>>& triangles, const RunContext& ctx,
                                  const ErrorDensityOptions& options) {
  FORAMEN_ASSERT(density.size() == grid.rows * grid.columns);
  check_options("raised_by_error", options);
  const GridNeighbours neighbours(grid);
  const std::size_t points = density.size();
  std::vector<std::vector<double>> each(shapes.size());
  parallel_for(static_cast<int>(shapes.size()), ctx,
               [&](int i) { each[i] = errors_on_grid(shapes[i], neighbours, points, triangles); });
  std::vector<double> factor(points, 0.0);
  for (const auto& errors : each)
    for (std::size_t k = 0; k < points; ++k) factor[k] = std::max(factor[k], errors[k]);
  for (int k = 0; k < options.spread_rings; ++k)
    factor = neighbours.filtered(
        factor, [](const auto& ring) { return *std::max_element(ring.begin(), ring.end()); });
  for (double& f : factor) f = std::pow(std::max(1.0, f / options.accepted_mm), options.exponent);
  for (int k = 0; k < smoothing_rounds; ++k)
    factor = neighbours.filtered(factor, [](const auto& ring) {
      return 0.5 * ring[0] + 0.125 * (ring[1] + ring[2] + ring[3] + ring[4]);
    });
  VertexMap<double> raised = density;
  for (std::size_t k = 0; k < points; ++k) raised.values()[k] *= factor[k];
  return raised;
}

}  // namespace foramen
