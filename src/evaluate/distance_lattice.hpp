#pragma once
/// \file
/// Distances to many fixed surfaces, bounded from a table.

#include <array>
#include <span>
#include <vector>

#include "evaluate/measured_surface.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen::detail {

/// Squared distances to several surfaces at the nodes of a cubic lattice around a middle surface.
///
/// The squared distance to any set, less |p|^2, is concave: it is the smallest of the functions |y|^2 - 2
/// y.p. So a convex combination p = sum w_j x_j of nodes gives d(p)^2 >= sum w_j d(x_j)^2 - sum w_j |x_j -
/// p|^2, and with trilinear weights the last sum is h^2 sum t (1 - t) over the axes: a lower bound that is
/// wrong by the second order of the spacing only.
class DistanceLattice {
 public:
  /// \param reach  nodes farther than this from the middle surface are left out; points there get the bound 0
  DistanceLattice(const MeasuredSurface& middle, const std::vector<MeasuredSurface>& surfaces, double reach,
                  double spacing, const RunContext& ctx);

  /// Lower bounds of the distances of p to all surfaces; false (and nothing written) where the lattice does
  /// not reach. \param bounds  width() numbers, those beyond the number of surfaces of no meaning
  bool lower_bounds(const Vec3& p, std::span<float> bounds) const;
  /// True only if p is at a distance <= radius of the surface; false where the table cannot tell.
  bool surely_within(std::size_t surface, const Vec3& p, double radius) const;
  /// Surfaces, rounded up to whole lanes.
  std::size_t width() const { return width_; }

 private:
  struct Place {
    std::array<int, 3> cell;
    std::array<double, 3> t;  // 0 .. 1 within the cell
  };
  bool locate(const Vec3& p, Place& place) const;
  std::size_t node(int i, int j, int k) const {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(size_[0]) +
           static_cast<std::size_t>(i);
  }
  Vec3 point(int i, int j, int k) const { return low_ + spacing_ * Vec3(i, j, k); }

  double spacing_;
  Vec3 low_;
  std::array<int, 3> size_{};
  std::size_t width_;
  std::vector<int> row_;        // per node; -1 out of reach
  std::vector<float> squared_;  // rows of width_ numbers, rounded down
};

}  // namespace foramen::detail
