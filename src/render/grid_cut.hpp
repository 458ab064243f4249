#pragma once
/// \file
/// A triangle of the plane cut along the lines of the unit grid.

#include <array>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

struct GridCorner {
  Vec2 at;           ///< in the plane of the grid
  Vec3 barycentric;  ///< in the triangle that was cut
};

/// A convex part of the triangle inside one cell of the grid.
struct GridPiece {
  Vec2i cell;                       ///< the piece lies in [cell, cell + 1], exactly
  std::vector<GridCorner> corners;  ///< at least three, in the triangle's sense of rotation
};

/// Cuts the triangle along all lines x = integer and y = integer. The pieces cover the triangle and share
/// only their borders. They are ordered by columns from left to right, and from bottom to top within a
/// column. A triangle that no line crosses is one piece.
/// \pre coordinates are finite and below 2^31.
std::vector<GridPiece> cut_by_grid(const std::array<Vec2, 3>& triangle);

}  // namespace foramen
