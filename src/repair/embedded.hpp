#pragma once
// Self-intersections of a mesh, with a limit on their number.

#include <utility>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// Pairs of intersecting triangles (see self_intersections()). Throws ConvergenceError if there are too many
/// to list.
std::vector<std::pair<FaceId, FaceId>> meeting_pairs(const Mesh& mesh);

/// Whether no face with an index of at least `first` intersects another face.
bool new_faces_are_embedded(const Mesh& mesh, int first);

}  // namespace foramen::repair_detail
