#pragma once
// Connected pieces of a soup without non-manifold edges: selection and consistent winding.

#include <vector>

#include "repair/raw_surface.hpp"

namespace foramen::repair_detail {

/// A dropped piece.
struct DroppedPiece {
  double area = 0;            ///< mm^2
  Vec3 position;              ///< centre of its bounding box
  std::vector<Vec3> samples;  ///< centres of a few of its triangles
};

/// Keeps the piece whose bounding box has the longest diagonal (the first of equals); drops the others.
std::vector<DroppedPiece> keep_largest_piece(RawSurface& surface);

/// Winds all triangles in the direction of the majority and returns for each triangle whether it was
/// reversed. Throws TopologyError with a position if the surface cannot be oriented (a Moebius strip). \pre
/// one piece, no edge with more than two triangles
std::vector<char> wind_alike(RawSurface& surface);

}  // namespace foramen::repair_detail
