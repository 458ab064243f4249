#include "correspond/feature_targets.hpp"

#include <cmath>
#include <utility>

#include <Eigen/LU>

#include "foramen/core/geometry.hpp"
#include "match/principal_curvatures.hpp"

namespace foramen {

VertexMap<Vec2> curvature_features(const Mesh& mesh, const FeatureTargetsOptions& options) {
  const double radius_mm = options.radius_mm, half_way = options.half_way;
  const auto curvatures = principal_curvatures(mesh, vertex_normals(mesh), radius_mm);
  VertexMap<Vec2> features(mesh.vertex_count(), Vec2::Zero());
  for (VertexId v : mesh.vertices())
    features[v] = {std::tanh(curvatures[v].largest / half_way), std::tanh(curvatures[v].smallest / half_way)};
  return features;
}

FeatureTargets::FeatureTargets(std::unique_ptr<CorrespondenceObjective> further, const Mesh& shape,
                               const TorusLocator& template_locator, const TorusMap& template_map,
                               const VertexMap<Vec2>& features, const FeatureTargetsOptions& options)
    : further_(std::move(further)),
      locator_(template_locator),
      features_(features),
      own_(curvature_features(shape, options)),
      to_turns_(template_map.lattice.inverse()),
      slopes_(template_locator.mesh().face_count(), Mat2::Zero()),
      options_(options) {
  const Mesh& surface = locator_.mesh();
  for (FaceId f : surface.faces()) {
    const auto plane = plane_triangle(surface, template_map, f);
    const auto c = surface.corners(f);
    Mat2 edges, changes;
    edges << plane[1] - plane[0], plane[2] - plane[0];
    changes << features_[c[1]] - features_[c[0]], features_[c[2]] - features_[c[0]];
    slopes_[f] = changes * edges.inverse();
  }
}

CorrespondenceObjective::Term FeatureTargets::term(VertexId v, const Vec2& plane_position) const {
  Term term = further_->term(v, plane_position);
  const SurfacePoint place = locator_.locate(Vec2(to_turns_ * plane_position));
  const auto c = locator_.mesh().corners(place.face);
  Vec2 difference = -own_[v];
  for (std::size_t k = 0; k < 3; ++k)
    difference += place.barycentric[static_cast<Eigen::Index>(k)] * features_[c[k]];
  const double squared = difference.squaredNorm(), s2 = options_.robust_difference * options_.robust_difference;
  const double damping = 1 / (1 + squared / s2), weight = options_.weight_mm2;
  const Mat2& slope = slopes_[place.face];
  term.value += weight * squared * damping;
  term.gradient += 2 * weight * damping * damping * slope.transpose() * difference;
  term.hessian += 2 * weight * damping * damping * slope.transpose() * slope;
  return term;
}

}  // namespace foramen
