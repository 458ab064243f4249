#pragma once
// Triangulation of a loop in space by a disk.

#include <array>
#include <functional>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// The longest loop that a disk of least area is sought for: the search grows with the cube of it.
inline constexpr int most_loop_points = 400;

struct Disk {
  std::vector<Vec3> inner;                    ///< new points, numbered after those of the loop
  std::vector<std::array<int, 3>> triangles;  ///< wound along the loop
};

/// The triangulation of least area without new points \cite barequet1995, then refined until its edges are
/// about as long as those of the loop, and flipped to be Delaunay as far as a surface in space can be \cite
/// liepa2003. \param joined  whether two points of the loop, by index, have an edge outside the disk; it gets
/// no second one \pre 3 to most_loop_points points
Disk disk_of(const std::vector<Vec3>& loop, const std::function<bool(int, int)>& joined);

}  // namespace foramen::repair_detail
