#pragma once
/// \file
/// The surface to which shapes are registered, with its map to the common torus.

#include "foramen/core/mesh.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// The first fundamental form G of the template in the plane of its map, per vertex: a small displacement dx
/// in the plane has the length \f$ \sqrt{dx^T G\, dx} \f$ mm on the template. G is the area-weighted mean
/// over the triangles at a vertex, so that it can be interpolated continuously.
VertexMap<Mat2> metric_tensors(const TemplateSurface& surface);

/// The tensor interpolated at a point of the surface.
Mat2 interpolated(const Mesh& mesh, const VertexMap<Mat2>& tensors, const SurfacePoint& place);

}  // namespace foramen
