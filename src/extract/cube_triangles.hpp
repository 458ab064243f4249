#pragma once
/// \file
/// Private to extract: the triangles that separate the inside corners of a cube from the outside ones.

#include <array>
#include <vector>

#include "foramen/extract/extract_label.hpp"

namespace foramen::extract {

/// Corner c of the unit cube is at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge 4 a + u + 2 v runs along axis a; u
/// and v are its coordinates along the axes (a + 1) % 3 and (a + 2) % 3.
struct CubeEdge {
  int axis;
  std::array<int, 3> from;  ///< the corner at its lower end
};
CubeEdge cube_edge(int edge);

/// The triangles for the inside corners given by the bits of `inside`, wound outward. Their vertices are
/// given by cube edges: each edge between an inside and an outside corner has one vertex.
///
/// The vertices on a face are joined by segments that depend on the corners of this face only, so two cubes
/// agree on their common face. If two opposite corners of a face are inside and the others are not, `contact`
/// decides whether the inside is connected across the face. The segments form loops, which are triangulated
/// without diagonals between two edges of one face, so no other cube has the same diagonal. Therefore the
/// triangles of all cubes of a lattice form a closed 2-manifold for any corners.
const std::vector<std::array<int, 3>>& cube_triangles(unsigned inside, EdgeContact contact);

}  // namespace foramen::extract
