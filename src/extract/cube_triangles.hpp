#pragma once
/// \file
/// Private to extract: the triangles that separate the corners of a cube, for every choice of corners.

#include <array>
#include <vector>

#include "foramen/extract/extract_label.hpp"

namespace foramen::extract {

/// Corner c of the unit cube is at (c & 1, c >> 1 & 1, c >> 2 & 1). Edge 4 a + u + 2 v runs along axis a; u
/// and v are its coordinates along the axes (a + 1) % 3 and (a + 2) % 3.
struct CubeEdge {
  int axis;
  std::array<int, 3> from;  ///< its lower corner
};
CubeEdge cube_edge(int edge);

/// Triangles as edges of the cube, wound outward, for the corners whose bits are set in `inside`. Every edge
/// between an inside and an outside corner carries one vertex.
///
/// The vertices on a face of the cube are joined by what that face alone shows, so two cubes agree on their
/// common face: where two opposite corners of a face are inside and two are not, `contact` says whether the
/// inside is joined across the face. The loops that these segments form are triangulated without a diagonal
/// between two edges of one face, so a diagonal is in no other cube. So the triangles of all cubes of a
/// lattice form a closed 2-manifold whatever the corners are.
const std::vector<std::array<int, 3>>& cube_triangles(unsigned inside, EdgeContact contact);

}  // namespace foramen::extract
