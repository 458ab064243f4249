#pragma once
// Triangulation of a loop in space by a disk.

#include <array>
#include <functional>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// Largest number of points of a loop. The time of the search for the disk of least area grows with its cube.
inline constexpr int most_loop_points = 400;

struct Disk {
  std::vector<Vec3> inner;                    ///< new points, with indices after those of the loop
  std::vector<std::array<int, 3>> triangles;  ///< wound along the loop
};

/// Triangulates a loop: computes the triangulation of least area without new points \cite barequet1995,
/// refines it until its edges are about as long as those of the loop, and flips edges towards a Delaunay
/// triangulation \cite liepa2003. The disk is empty if there is no such triangulation. \pre 3 to
/// most_loop_points points
/// \param joined  whether two points of the loop, given by index, are joined by an edge outside the disk; the
/// disk gets no second edge between them
Disk disk_of(const std::vector<Vec3>& loop, const std::function<bool(int, int)>& joined);

}  // namespace foramen::repair_detail
