#pragma once
// Makes every edge belong to at most two triangles and every vertex to one fan.

#include <vector>

#include "repair/raw_surface.hpp"

namespace foramen::repair_detail {

struct OpenedPlaces {
  std::vector<Vec3> flaps;     ///< middle of each piece dropped
  std::vector<Vec3> edges;     ///< middle of each non-manifold edge
  std::vector<Vec3> vertices;  ///< that were doubled and lie on no such edge
};

/// At an edge with three or more triangles: first pieces that end there and are not needed to close the
/// others are dropped, the smaller ones first (flaps, inner walls). Then the triangles that are left are
/// joined two by two so that each two have solid between them, and the pairs are taken apart: parts of the
/// solid that touch along the edge are separated. What finds no partner is left with a border. Vertices are
/// doubled where this, or touching in one point alone, leaves several fans. New points come last. \pre no
/// triangle has a corner twice, none is there twice
OpenedPlaces open_non_manifold(RawSurface& surface);

}  // namespace foramen::repair_detail
