#pragma once
// Removal of a handle for the further search, without regard to geometry.

#include "foramen/topology/shortest_loops.hpp"

namespace foramen::repair_detail {

/// Cuts the surface along a simple loop and closes each side by a fan of triangles around the centre of the
/// loop, which lowers the genus by one. The two fans coincide in space, so the result serves the search for
/// further handles only. Old vertices and faces keep their indices.
Mesh cut_and_closed(const Mesh& mesh, const EdgeLoop& loop);

Vec3 loop_centre(const Mesh& mesh, const EdgeLoop& loop);

}  // namespace foramen::repair_detail
