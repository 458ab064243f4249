#pragma once
/// \file
/// The surface that shapes are registered to, with its map to the torus they all share.

#include "foramen/core/surface_point.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// The template's first fundamental form in the plane of its map, per vertex: a small motion dx in the plane
/// moves by \f$ \sqrt{dx^T G\, dx} \f$ mm on the template. The area-weighted mean over the triangles at each
/// vertex, so that it varies continuously when interpolated.
VertexMap<Mat2> metric_tensors(const TemplateSurface& surface);

/// The tensor at a place between vertices.
Mat2 interpolated(const Mesh& mesh, const VertexMap<Mat2>& tensors, const SurfacePoint& place);

}  // namespace foramen
