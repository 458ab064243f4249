#include "correspond/template_surface.hpp"

#include <Eigen/LU>

#include "foramen/core/geometry.hpp"
#include "parameterize/distortion.hpp"

namespace foramen {
namespace {

// The first fundamental form of the affine map from a triangle in the plane to the triangle in space.
Mat2 first_fundamental_form(const TemplateSurface& surface, FaceId f) {
  const auto plane = plane_triangle(surface.mesh, surface.map, f);
  Mat2 edges;
  edges << plane[1] - plane[0], plane[2] - plane[0];
  const Mat2 to_plane = edges * rest_triangle(surface.mesh.triangle(f), 1).inverse;
  return (to_plane * to_plane.transpose()).inverse();
}

}  // namespace

VertexMap<Mat2> metric_tensors(const TemplateSurface& surface) {
  const Mesh& mesh = surface.mesh;
  VertexMap<Mat2> tensors(mesh.vertex_count(), Mat2::Zero());
  VertexMap<double> areas(mesh.vertex_count(), 0.0);
  for (FaceId f : mesh.faces()) {
    const double weight = area(mesh.triangle(f));
    const Mat2 form = first_fundamental_form(surface, f);
    for (VertexId v : mesh.corners(f)) {
      tensors[v] += weight * form;
      areas[v] += weight;
    }
  }
  for (VertexId v : mesh.vertices()) tensors[v] /= areas[v];
  return tensors;
}

Mat2 interpolated(const Mesh& mesh, const VertexMap<Mat2>& tensors, const SurfacePoint& place) {
  const auto corners = mesh.corners(place.face);
  Mat2 sum = Mat2::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    sum += place.barycentric[static_cast<Eigen::Index>(k)] * tensors[corners[k]];
  return sum;
}

}  // namespace foramen
