#include "correspond/feature_targets.hpp"

#include <utility>

#include <Eigen/LU>

#include "correspond/template_surface.hpp"
#include "foramen/core/geometry.hpp"
#include "match/principal_curvatures.hpp"

namespace foramen {

VertexMap<Vec2> curvature_features(const Mesh& mesh, const FeatureTargetsOptions& options) {
  const auto curvatures = principal_curvatures(mesh, vertex_normals(mesh), options.radius_mm);
  VertexMap<Vec2> features(mesh.vertex_count(), Vec2::Zero());
  for (VertexId v : mesh.vertices()) features[v] = squashed(curvatures[v]);
  return features;
}

FeatureField::FeatureField(const TemplateSurface& surface, VertexMap<Vec2> features)
    : features_(std::move(features)),
      slopes_(surface.mesh.vertex_count(), Mat2::Zero()),
      to_turns_(surface.map.lattice.inverse()) {
  VertexMap<double> areas(surface.mesh.vertex_count(), 0);
  for (FaceId f : surface.mesh.faces()) {
    const auto plane = plane_triangle(surface.mesh, surface.map, f);
    const auto c = surface.mesh.corners(f);
    Mat2 edges, changes;
    edges << plane[1] - plane[0], plane[2] - plane[0];
    changes << features_[c[1]] - features_[c[0]], features_[c[2]] - features_[c[0]];
    const double area_of_face = area(surface.mesh.triangle(f));
    const Mat2 slopes = changes * edges.inverse();
    for (VertexId corner : c) {
      slopes_[corner] += area_of_face * slopes;
      areas[corner] += area_of_face;
    }
  }
  for (VertexId v : surface.mesh.vertices())
    if (areas[v] > 0) slopes_[v] /= areas[v];
}

FeatureField::Value FeatureField::at(const TorusLocator& locator, const Vec2& plane_position) const {
  const SurfacePoint place = locator.locate(Vec2(to_turns_ * plane_position));
  return {interpolated(locator.mesh(), features_, place), interpolated(locator.mesh(), slopes_, place)};
}

FeatureTargets::FeatureTargets(const CorrespondenceObjective& further, const VertexMap<Vec2>& own,
                               const TorusMap& map, const FeatureField& field, const TorusLocator& locator,
                               const FeatureTargetsOptions& options)
    : further_(further), reducer_(map.lattice) {
  const double scale2 = options.robust_difference * options.robust_difference;
  linear_.reserve(own.values().size());
  for (std::size_t i = 0; i < own.values().size(); ++i) {
    const VertexId v(static_cast<int>(i));
    const Vec2 place = map.lattice * map.turns[v];
    const FeatureField::Value value = field.at(locator, place);
    const Vec2 difference = value.features - own[v];
    const double damping = 1 / (1 + difference.squaredNorm() / scale2);
    linear_.push_back({place, value.slopes, difference, options.weight_mm2 * damping * damping});
  }
}

CorrespondenceObjective::Term FeatureTargets::term(VertexId v, const Vec2& plane_position) const {
  Term term = further_.term(v, plane_position);
  const Linear& at = linear_[v.index];
  const Vec2 residual = at.difference + at.slopes * reducer_.shortest(plane_position - at.place);
  term.value += at.weight * residual.squaredNorm();
  term.gradient += 2 * at.weight * at.slopes.transpose() * residual;
  term.hessian += 2 * at.weight * at.slopes.transpose() * at.slopes;
  return term;
}

}  // namespace foramen
