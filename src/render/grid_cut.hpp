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

/// The triangle cut along all lines x = integer and y = integer: its pieces fill it and overlap in lines
/// only. Columns from left to right, each from bottom to top. A triangle that no line crosses is one piece.
/// \pre coordinates are finite and below 2^31.
std::vector<GridPiece> cut_by_grid(const std::array<Vec2, 3>& triangle);

}  // namespace foramen
