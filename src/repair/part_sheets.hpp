#pragma once
/// \file
/// Separation of sheets of a surface that intersect each other.

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

struct PartSheetsOptions {
  double largest_move_mm = 0.5;  ///< No change moves a kept vertex by more than this [mm].
};

struct PartedSheets {
  Mesh mesh;
  VertexMap<VertexId> origin;   ///< per vertex: its index in the input; invalid for a new vertex
  std::vector<Vec3> positions;  ///< one position per pair of triangles that was separated, mm
  std::vector<Vec3> remaining;  ///< one position per pair that still intersects, mm
  double largest_move_mm = 0;   ///< largest displacement of a kept vertex
};

/// Removes self-intersections place by place, where a place consists of connected intersecting triangles and
/// two rings of vertices around them. Changes of increasing size are tried, and the first one that frees the
/// place of intersections is kept: the vertices are moved outward (if a wall has negative thickness) or
/// inward (if a gap has), or they are smoothed. If none of these succeeds, the place is cut out and closed by
/// disks. A place that nothing repairs is left unchanged. Throws ConvergenceError if there are too many
/// self-intersections to list. \pre closed, wound outward
PartedSheets part_sheets(const Mesh& mesh, const PartSheetsOptions& options = {});

}  // namespace foramen
