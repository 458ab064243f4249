#pragma once
/// \file
/// Whether two triangles of one surface meet.

#include <array>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// Corners of equal number are the same vertex.
struct NumberedTriangle {
  std::array<VertexId, 3> corners;
  std::array<Vec3, 3> points;
};

inline NumberedTriangle numbered_triangle(const Mesh& mesh, FaceId f) {
  return {mesh.corners(f), mesh.triangle(f)};
}

/// Whether two triangles have a point in common beyond what they share as neighbours: the definition of
/// self_intersections(), exact. \pre both have area, by has_area()
bool triangles_meet(const NumberedTriangle& a, const NumberedTriangle& b);

/// Whether the corners are not exactly on one line.
bool has_area(const std::array<Vec3, 3>& triangle);

}  // namespace foramen
