#pragma once
// Pieces of a soup without non-manifold edges: which to keep, and how to wind it.

#include <vector>

#include "repair/raw_surface.hpp"

namespace foramen::repair_detail {

/// A piece that was dropped.
struct DroppedPiece {
  double area = 0;            ///< mm^2
  Vec3 position;              ///< centre of its box
  std::vector<Vec3> samples;  ///< a few of its points
};

/// Keeps the piece whose bounding box has the longest diagonal (the first of equals); drops the others.
std::vector<DroppedPiece> keep_largest_piece(RawSurface& surface);

/// Winds all triangles as most of them are; marks those that were turned. Throws TopologyError naming the
/// place where the surface cannot be oriented (a Moebius band). \pre one piece, no edge with more than two
/// triangles
std::vector<char> wind_alike(RawSurface& surface);

}  // namespace foramen::repair_detail
