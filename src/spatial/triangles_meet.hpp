#pragma once
/// \file
/// Exact intersection test of two triangles of one surface.

#include <array>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A triangle with the ids of its vertices. Corners with equal ids are the same vertex.
struct NumberedTriangle {
  std::array<VertexId, 3> corners;
  std::array<Vec3, 3> points;
};

inline NumberedTriangle numbered_triangle(const Mesh& mesh, FaceId f) {
  return {mesh.corners(f), mesh.triangle(f)};
}

/// Whether two triangles intersect by the definition of self_intersections(), decided exactly. \pre both have
/// area, by has_area()
bool triangles_meet(const NumberedTriangle& a, const NumberedTriangle& b);

/// Whether the corners are not exactly on one line.
bool has_area(const std::array<Vec3, 3>& triangle);

}  // namespace foramen
