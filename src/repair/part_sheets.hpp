#pragma once
/// \file
/// Parting of sheets of a surface that run through each other.

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

struct PartSheetsOptions {
  double largest_move_mm = 0.5;  ///< No vertex that is kept is moved further than this [mm].
};

struct PartedSheets {
  Mesh mesh;
  VertexMap<VertexId> origin;   ///< per vertex: the vertex before; invalid: new
  std::vector<Vec3> positions;  ///< of each pair of triangles that met and does no more, mm
  std::vector<Vec3> remaining;  ///< of each pair that meets still
  double largest_move_mm = 0;   ///< of a vertex that was kept
};

/// Undoes self-intersections place by place, a place being some triangles that meet and two rings round them.
/// From the least on, these changes are tried, and the first is made that leaves the place without any: its
/// sheets moved outward (a wall thinner than nothing) or inward (a gap), smoothed, or cut out and closed by
/// disks. Where none helps, nothing is changed. \pre closed, outward. ConvergenceError if the surface runs
/// through itself so often that the pairs cannot be listed.
PartedSheets part_sheets(const Mesh& mesh, const PartSheetsOptions& options = {});

}  // namespace foramen
