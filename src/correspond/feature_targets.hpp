#pragma once
/// \file
/// Targets of a shape's map together with the agreement of its curvatures with those of the template.

#include <memory>

#include "foramen/correspond/group_options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "parameterize/optimise_map.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {

/// The two principal curvatures at each vertex, squashed: tanh(k / 0.3 mm).
VertexMap<Vec2> curvature_features(const Mesh& mesh, const FeatureTargetsOptions& options);

/// Adds to an objective, for each vertex v of the shape at the place x of the template,
///
///     weight rho(|f_template(x) - f_shape(v)|^2),   rho(t) = t / (1 + t / s^2),
///
/// where f are the squashed principal curvatures. Ridges of the shape, such as the rims of the body and of the
/// facets, are thus drawn to ridges of the template, along whose walls the nearest surface says nothing.
class FeatureTargets : public CorrespondenceObjective {
 public:
  /// \param features  of the template's vertices, see curvature_features(). Both are used as long as this object.
  FeatureTargets(std::unique_ptr<CorrespondenceObjective> further, const Mesh& shape,
                 const TorusLocator& template_locator, const TorusMap& template_map,
                 const VertexMap<Vec2>& features, const FeatureTargetsOptions& options);
  Term term(VertexId v, const Vec2& plane_position) const override;

 private:
  std::unique_ptr<CorrespondenceObjective> further_;
  const TorusLocator& locator_;
  const VertexMap<Vec2>& features_;
  VertexMap<Vec2> own_;
  Mat2 to_turns_;
  FaceMap<Mat2> slopes_;  // of the template's features by plane position
  FeatureTargetsOptions options_;
};

}  // namespace foramen
