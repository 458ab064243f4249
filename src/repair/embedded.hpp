#pragma once
// Self-intersections, counted within bounds.

#include <utility>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// Pairs of triangles that meet (see self_intersections). ConvergenceError if there are too many to list.
std::vector<std::pair<FaceId, FaceId>> meeting_pairs(const Mesh& mesh);

/// Whether no face from number `first` on meets another.
bool new_faces_are_embedded(const Mesh& mesh, int first);

}  // namespace foramen::repair_detail
