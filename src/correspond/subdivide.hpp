#pragma once
/// \file
/// A template with more vertices on the same surface.

#include <span>
#include <vector>

#include "foramen/correspond/registration_frame.hpp"

namespace foramen {

/// Every triangle divided into four by the midpoints of its edges. Vertices keep their indices, and the
/// midpoint of edge e is vertex vertex_count + e. The map is linear on every triangle, as before.
TemplateSurface subdivided(const TemplateSurface& surface);

/// Corresponding points of another shape, followed by the midpoints of the mesh's edges between them.
std::vector<Vec3> with_edge_midpoints(const Mesh& mesh, std::span<const Vec3> points);

}  // namespace foramen
