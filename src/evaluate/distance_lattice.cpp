#include "evaluate/distance_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen::detail {
namespace {

using Floats = Eigen::Array4f;
constexpr std::size_t lanes = 4;
// Bound of the relative rounding error of about 20 single-precision operations on numbers of one sign.
constexpr float rounding = 4e-6f;
// Bound of the rounding of positions to single precision within a cell, relative to the spacing.
constexpr float rounding_in_cell = 1e-6f;
// Limits of the memory for the nodes and for the stored distances (16 MB and 1 GB).
constexpr double most_nodes = 1 << 22, most_distances = 1 << 28;
constexpr int nothing = -1;

float rounded_down(double x) {
  return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}

}  // namespace

DistanceLattice::DistanceLattice(const MeasuredSurface& middle, const std::vector<MeasuredSurface>& surfaces,
                                 double reach, double spacing, const RunContext& ctx)
    : spacing_(spacing), width_((surfaces.size() + lanes - 1) / lanes * lanes) {
  while (!lay_out(middle, reach, ctx)) spacing_ *= 2;
  squared_.assign(static_cast<std::size_t>(rows_) * width_, 0.0f);
  parallel_for(size_[2], ctx, [&](int k) {
    for_nodes_of_layer(k, [&](std::size_t n, const Vec3& x) {
      if (row_[n] == nothing) return;
      float* row = squared_.data() + static_cast<std::size_t>(row_[n]) * width_;
      for (std::size_t s = 0; s < surfaces.size(); ++s)
        row[s] = std::max(0.0f, rounded_down(surfaces[s].tree().squared_distance(x)));
    });
  });
}

bool DistanceLattice::lay_out(const MeasuredSurface& middle, double reach, const RunContext& ctx) {
  const BoundingBox box = bounding_box(middle.tree().mesh().positions());
  low_ = box.low - Vec3::Constant(reach + spacing_);
  double nodes = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    const double along = std::ceil((box.high[axis] + reach + spacing_ - low_[axis]) / spacing_) + 1;
    nodes *= along;
    if (nodes > most_nodes) return false;
    size_[a] = static_cast<int>(along);
  }
  row_.assign(static_cast<std::size_t>(nodes), nothing);
  parallel_for(size_[2], ctx, [&](int k) {
    for_nodes_of_layer(k, [&](std::size_t n, const Vec3& x) {
      if (middle.tree().any_within(x, reach)) row_[n] = 0;
    });
  });
  rows_ = 0;
  for (int& row : row_)
    if (row != nothing) row = rows_++;
  return static_cast<double>(rows_) * static_cast<double>(width_) <= most_distances;
}

bool DistanceLattice::locate(const Vec3& p, Place& place) const {
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    const double x = (p[axis] - low_[axis]) / spacing_;
    if (!(x >= 0) || !(x < size_[a] - 1)) return false;
    place.cell[a] = static_cast<int>(x);
    place.t[a] = x - place.cell[a];
  }
  return true;
}

bool DistanceLattice::lower_bounds(const Vec3& p, std::span<float> bounds) const {
  Place place;
  if (!locate(p, place)) return false;
  const auto [i, j, k] = place.cell;
  std::array<const float*, 8> rows{};
  std::array<float, 8> weights{};
  for (int corner = 0; corner < 8; ++corner) {
    const int right = corner & 1, back = (corner >> 1) & 1, up = corner >> 2;
    const int row = row_[node(i + right, j + back, k + up)];
    if (row == nothing) return false;
    const double wx = right ? place.t[0] : 1 - place.t[0], wy = back ? place.t[1] : 1 - place.t[1],
                 wz = up ? place.t[2] : 1 - place.t[2];
    rows[corner] = squared_.data() + static_cast<std::size_t>(row) * width_;
    weights[corner] = static_cast<float>(wx * wy * wz);
  }
  double spread = 0;
  for (const double t : place.t) spread += t * (1 - t);
  const auto subtracted = static_cast<float>(spacing_ * spacing_ * spread) * (1 + rounding);
  const auto lost_in_cell = static_cast<float>(spacing_) * rounding_in_cell;
  for (std::size_t s = 0; s < width_; s += lanes) {
    Floats sum = Floats::Zero();
    for (std::size_t c = 0; c < 8; ++c) sum += weights[c] * Eigen::Map<const Floats>(rows[c] + s);
    Eigen::Map<Floats>(bounds.data() + s) =
        ((sum * (1 - rounding) - subtracted).max(0.0f).sqrt() * (1 - rounding) - lost_in_cell).max(0.0f);
  }
  return true;
}

bool DistanceLattice::surely_within(std::size_t surface, const Vec3& p, double radius) const {
  Place place;
  if (!locate(p, place)) return false;
  std::array<int, 3> nearest{};
  for (std::size_t a = 0; a < 3; ++a) nearest[a] = place.cell[a] + (place.t[a] > 0.5 ? 1 : 0);
  const int row = row_[node(nearest[0], nearest[1], nearest[2])];
  if (row == nothing) return false;
  const double squared = static_cast<double>(squared_[static_cast<std::size_t>(row) * width_ + surface]);
  const double from_node = (p - point(nearest[0], nearest[1], nearest[2])).norm();
  const auto margin = static_cast<double>(rounding);
  return std::sqrt(squared) * (1 + margin) + margin * spacing_ + from_node <= radius;
}

}  // namespace foramen::detail
