#include "correspond/surface_targets.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "match/robust_weight.hpp"

namespace foramen {

SurfaceTargets::SurfaceTargets(const Mesh& shape, const TemplateSurface& surface,
                               const VertexMap<Mat2>& tensors, std::vector<Vec3> bent,
                               const SurfaceTargetsOptions& options)
    : reducer_(surface.map.lattice), targets_(shape.vertex_count()) {
  check_options("SurfaceTargets", options);
  const TriangleTree tree(surface.mesh.with_positions(std::move(bent)));
  const VertexMap<Vec3> normals = vertex_normals(shape);
  for (VertexId v : shape.vertices()) {
    const auto near =
        tree.closest_compatible(shape.position(v), normals[v], options.min_normal_cosine, options.reach_mm);
    if (!near || !near->on.face.valid()) continue;
    const auto plane = plane_triangle(surface.mesh, surface.map, near->on.face);
    Target& target = targets_[v.index];
    for (std::size_t k = 0; k < 3; ++k)
      target.position += near->on.barycentric[static_cast<Eigen::Index>(k)] * plane[k];
    const double ratio2 = near->squared_distance / (options.reach_mm * options.reach_mm);
    target.weight = tukey_weight(ratio2) * interpolated(surface.mesh, tensors, near->on);
  }
}

CorrespondenceObjective::Term SurfaceTargets::term(VertexId v, const Vec2& plane_position) const {
  const Target& target = targets_[v.index];
  const Vec2 d = reducer_.shortest(plane_position - target.position);
  const Vec2 weighted = target.weight * d;
  return {d.dot(weighted), 2 * weighted, 2 * target.weight};
}

double SurfaceTargets::share_without() const {
  const auto without =
      std::count_if(targets_.begin(), targets_.end(), [](const Target& t) { return t.weight.isZero(0); });
  return static_cast<double>(without) / static_cast<double>(targets_.size());
}

}  // namespace foramen
