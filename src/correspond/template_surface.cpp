#include "correspond/template_surface.hpp"

#include <utility>
#include <vector>

#include <Eigen/LU>

#include "foramen/core/geometry.hpp"
#include "parameterize/distortion.hpp"
#include "sampling/lift_to_surface.hpp"

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

VertexMap<Vec2> curvatures_at(const TemplateSurface& surface, std::span<const Vec2> turns) {
  if (surface.curvatures.values().empty()) return {};
  std::vector<Vec2> curvatures;
  curvatures.reserve(turns.size());
  for (const SurfacePoint& place : TorusLocator(surface.mesh, surface.map).locate(turns))
    curvatures.push_back(interpolated(surface.mesh, surface.curvatures, place));
  return VertexMap<Vec2>(std::move(curvatures));
}

}  // namespace foramen
