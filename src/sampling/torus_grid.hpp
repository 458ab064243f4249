#pragma once
/// \file
/// The dense uniform sampling of the torus.

#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// A regular triangulation of the torus with rows x columns points, near-equilateral for the given lattice.
/// Vertex r * columns + c stands at turns (c / columns, r / rows).
struct TorusGrid {
  int rows = 0, columns = 0;
  std::vector<Vec2> turns;
  std::vector<std::array<int, 3>> triangles;  ///< positive in the plane; the shorter diagonal of every cell
  HalfedgeMap<Vec2i> jumps;                   ///< of the grid as a torus map of itself (halfedge 3f+k)
};

/// About `points` points; rows and columns follow the lattice's periods so that cells are near-square in the
/// plane.
TorusGrid make_torus_grid(const Lattice& lattice, int points);

}  // namespace foramen
