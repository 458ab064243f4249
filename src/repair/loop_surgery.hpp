#pragma once
// What a surface would be like without a handle.

#include "foramen/topology/shortest_loops.hpp"

namespace foramen::repair_detail {

/// The surface cut along a simple loop, each side closed by a fan of triangles about the loop's centre: of
/// one genus less. For further search only: the two fans lie on each other. Old vertices and faces keep their
/// numbers.
Mesh cut_and_closed(const Mesh& mesh, const EdgeLoop& loop);

Vec3 loop_centre(const Mesh& mesh, const EdgeLoop& loop);

}  // namespace foramen::repair_detail
