#pragma once
// Makes every edge belong to at most two triangles and every vertex to one fan.

#include <vector>

#include "repair/raw_surface.hpp"

namespace foramen::repair_detail {

struct OpenedPlaces {
  std::vector<Vec3> flaps;     ///< centre of each dropped piece
  std::vector<Vec3> edges;     ///< midpoint of each non-manifold edge
  std::vector<Vec3> vertices;  ///< vertices that were doubled and lie on no such edge
};

/// Removes non-manifold edges and vertices. First, pieces that have a border at an edge with three or more
/// triangles and are not needed to close the rest are dropped, smaller ones first (flaps, inner walls). Then
/// the remaining triangles of such an edge are joined in pairs that have solid between them, and the pairs
/// are separated, so parts of the solid that touch along the edge come apart. A triangle without partner gets
/// a border. Finally, each vertex with several fans of triangles is doubled. New points come last. \pre no
/// triangle has a repeated corner and no triangle occurs twice
OpenedPlaces open_non_manifold(RawSurface& surface);

}  // namespace foramen::repair_detail
