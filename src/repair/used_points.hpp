#pragma once
/// \file
/// Points of a surface that belong to no triangle.

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// Removes the points that belong to no triangle. Returns the former index of each point that is left, in
/// order. \pre the corners of all triangles exist
std::vector<int> keep_used_points(TriangleSoup& surface);

}  // namespace foramen::repair_detail
