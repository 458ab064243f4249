#pragma once
/// \file
/// Lower bounds of distances to many fixed surfaces by a lookup table.

#include <array>
#include <span>
#include <vector>

#include "evaluate/measured_surface.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen::detail {

/// Squared distances to several surfaces at the nodes of a cubic lattice around a middle surface.
///
/// The squared distance to a set minus |p|^2 is concave in p, because it is the minimum of the linear
/// functions |y|^2 - 2 y.p over the points y of the set. For a convex combination p = sum w_j x_j of nodes
/// this gives the lower bound d(p)^2 >= sum w_j d(x_j)^2 - sum w_j |x_j - p|^2. With trilinear weights the
/// last sum is h^2 sum t (1 - t) over the axes for the spacing h, so the error of the bound is of second
/// order in the spacing.
class DistanceLattice {
 public:
  /// \param spacing  the spacing of nodes; it is doubled until the table takes no more than about 1 GB
  /// \param reach  nodes farther than this from the middle surface are not stored, and lower_bounds() is
  /// false near them
  DistanceLattice(const MeasuredSurface& middle, const std::vector<MeasuredSurface>& surfaces, double reach,
                  double spacing, const RunContext& ctx);

  /// Writes lower bounds of the distances of p to all surfaces. False, with nothing written, if p is outside
  /// the stored nodes.
  /// \param bounds  width() numbers, of which those beyond the number of surfaces are meaningless
  bool lower_bounds(const Vec3& p, std::span<float> bounds) const;
  /// True only if the distance of p to the surface is certainly <= radius; false also if the table does not
  /// determine this.
  bool surely_within(std::size_t surface, const Vec3& p, double radius) const;
  /// The number of surfaces rounded up to a multiple of the SIMD lanes.
  std::size_t width() const { return width_; }

 private:
  struct Place {
    std::array<int, 3> cell;
    std::array<double, 3> t;  // coordinates within the cell, 0 .. 1
  };
  // Sets the nodes for the spacing; false if they would take too much memory.
  bool lay_out(const MeasuredSurface& middle, double reach, const RunContext& ctx);
  template <class Visit>
  void for_nodes_of_layer(int k, const Visit& visit) const {
    for (int j = 0; j < size_[1]; ++j)
      for (int i = 0; i < size_[0]; ++i) visit(node(i, j, k), point(i, j, k));
  }
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
  int rows_ = 0;                // stored nodes
  std::vector<int> row_;        // per node: index of its row; -1: not stored
  std::vector<float> squared_;  // rows of width_ numbers, rounded down
};

}  // namespace foramen::detail
