#pragma once
/// \file
/// The surface to which shapes are registered, with its map to the common torus.

#include <span>

#include "foramen/core/mesh.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// The first fundamental form G of the template in the plane of its map, per vertex: a small displacement dx
/// in the plane has the length \f$ \sqrt{dx^T G\, dx} \f$ mm on the template. G is the area-weighted mean
/// over the triangles at a vertex, so that it can be interpolated continuously.
VertexMap<Mat2> metric_tensors(const TemplateSurface& surface);

/// The vectors or tensors of the vertices, interpolated at a point of the surface.
template <class Matrix>
Matrix interpolated(const Mesh& mesh, const VertexMap<Matrix>& of_vertices, const SurfacePoint& place) {
  const auto corners = mesh.corners(place.face);
  Matrix sum = Matrix::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    sum += place.barycentric[static_cast<Eigen::Index>(k)] * of_vertices[corners[k]];
  return sum;
}

/// The curvatures of the surface at these torus positions; empty if it has none.
VertexMap<Vec2> curvatures_at(const TemplateSurface& surface, std::span<const Vec2> turns);

}  // namespace foramen
