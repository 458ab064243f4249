#pragma once
/// \file
/// A template with more vertices on the same surface.

#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/correspond/registration_frame.hpp"

namespace foramen {

/// Every triangle divided into four by the midpoints of its edges. Vertices keep their indices, and the
/// midpoint of edge e is vertex vertex_count + e. The map is linear on every triangle, as before.
TemplateSurface subdivided(const TemplateSurface& surface);

/// Values of the mesh's vertices, such as the corresponding points of another shape, followed by the mean of
/// the two ends of every edge.
template <class Values>
std::vector<typename Values::value_type> with_edge_midpoints(const Mesh& mesh, const Values& of_vertices) {
  FORAMEN_ASSERT(std::ssize(of_vertices) == mesh.vertex_count());
  std::vector<typename Values::value_type> all(of_vertices.begin(), of_vertices.end());
  all.reserve(of_vertices.size() + static_cast<std::size_t>(mesh.edge_count()));
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    all.push_back((of_vertices[mesh.from(h).index] + of_vertices[mesh.to(h).index]) / 2);
  }
  return all;
}

}  // namespace foramen
