#pragma once
/// \file
/// Private to io: a polygon as triangles.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::io_detail {

/// The most corners of a polygon that is read, since the time grows with their third power.
inline constexpr std::size_t most_corners = 200;

/// Cuts from the first corner to all others if that covers the polygon, as it does if it is convex, so that
/// corresponding surfaces get the same triangles. Else ears are cut off, each time the one with the shortest
/// cut, as seen along the normal of the whole polygon. The triangles are wound as the polygon, use its
/// corners alone, and are two fewer than the corners. Polygons need not be flat.
/// \pre 3 or more corners, at most most_corners, each an index of a point
std::vector<std::array<int, 3>> triangulate_polygon(std::span<const int> corners,
                                                    std::span<const Vec3> points);

}  // namespace foramen::io_detail
