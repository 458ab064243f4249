#pragma once
/// \file
/// The dense uniform sampling of the torus.

#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// A regular triangulation of the torus with rows x columns points. Vertex r * columns + c is at turns (c /
/// columns, r / rows).
struct TorusGrid {
  int rows = 0, columns = 0;
  std::vector<Vec2> turns;
  /// Positively oriented in the plane; each cell is divided by its shorter diagonal.
  std::vector<std::array<int, 3>> triangles;
  HalfedgeMap<Vec2i> jumps;  ///< jumps of halfedge 3f+k, as in TorusMap
};

/// Makes a grid of about `points` points. The numbers of rows and columns make the cells nearly square in the
/// plane of the lattice. Throws InvalidInput if the lattice has no positive area.
TorusGrid make_torus_grid(const Lattice& lattice, int points);

}  // namespace foramen
