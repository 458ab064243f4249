#pragma once
// A soup under repair, and the repairs that need no connectivity.

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// The current soup and the origin of its points.
struct RawSurface {
  TriangleSoup soup;
  std::vector<int> origin;  ///< per point: its index in the raw soup
  std::vector<int> joined;  ///< per raw point: the raw point that stands for it
};

/// Throws InvalidInput if there is no triangle, a coordinate is not finite or beyond 1e6 mm, or an index is
/// out of range.
RawSurface checked(const TriangleSoup& raw);

/// Each of these functions returns one position per change. All else keeps its position and order.
std::vector<Vec3> drop_unused_vertices(RawSurface& surface);
/// Merges vertices of exactly equal coordinates with the first of them.
std::vector<Vec3> join_duplicate_vertices(RawSurface& surface);
std::vector<Vec3> drop_triangles_with_repeated_corner(RawSurface& surface);
/// Of triangles with the same three corners, in any winding, keeps the first.
std::vector<Vec3> drop_duplicate_triangles(RawSurface& surface);
/// Drops the triangles that are not marked in `kept`.
void keep_triangles(RawSurface& surface, const std::vector<char>& kept);

Vec3 centre(const TriangleSoup& soup, const std::array<int, 3>& triangle);

}  // namespace foramen::repair_detail
