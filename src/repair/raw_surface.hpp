#pragma once
// A soup on its way to a mesh, and what can be mended without knowing its neighbours.

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// The soup as it is now, and the way back to the raw one.
struct RawSurface {
  TriangleSoup soup;
  std::vector<int> origin;  ///< per point: its index in the raw soup
  std::vector<int> joined;  ///< per raw point: the raw point that stands for it
};

/// Throws InvalidInput if there is no triangle, a coordinate is not finite or beyond 1e6 mm, or an index is
/// out of range.
RawSurface checked(const TriangleSoup& raw);

/// Each returns where something was changed, one position for each. Nothing else moves, the order stays.
std::vector<Vec3> drop_unused_vertices(RawSurface& surface);
/// Joins vertices of exactly the same coordinates with the first of them.
std::vector<Vec3> join_duplicate_vertices(RawSurface& surface);
std::vector<Vec3> drop_triangles_with_repeated_corner(RawSurface& surface);
/// The first of those with the same three corners stays, whatever their winding.
std::vector<Vec3> drop_duplicate_triangles(RawSurface& surface);
/// Keeps the triangles marked.
void keep_triangles(RawSurface& surface, const std::vector<char>& kept);

Vec3 centre(const TriangleSoup& soup, const std::array<int, 3>& triangle);

}  // namespace foramen::repair_detail
