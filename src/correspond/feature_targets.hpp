#pragma once
/// \file
/// Targets of a shape's map together with the agreement of its curvatures with those of the template.

#include <memory>

#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "parameterize/optimise_map.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {

/// The squashed() principal curvatures at each vertex. They do not change if the surface is moved.
VertexMap<Vec2> curvature_features(const Mesh& mesh, const FeatureTargetsOptions& options);

/// The features of a template as a function of the position in the plane.
class FeatureField {
 public:
  /// \param features  of the template's vertices, see curvature_features()
  FeatureField(const TemplateSurface& surface, VertexMap<Vec2> features);
  struct Value {
    Vec2 features;
    Mat2 slopes;  ///< change of the features by the plane position
  };
  /// \param locator  of the template
  Value at(const TorusLocator& locator, const Vec2& plane_position) const;

 private:
  VertexMap<Vec2> features_;
  VertexMap<Mat2> slopes_;  // mean of the triangles at each vertex, by area
  Mat2 to_turns_;
};

/// Adds to an objective, for each vertex v of the shape that moves from its present place x0 to x,
///
///     weight w |f(x0) + f'(x0) (x - x0) - f_v|^2,   w = 1 / (1 + |f(x0) - f_v|^2 / s^2)^2,
///
/// where f is the FeatureField of the template and f_v the feature of the shape. This is a Gauss-Newton
/// step of the robust squared difference. Ridges of the shape, such as the rims of the body and of the
/// facets, are thus drawn to ridges of the template; the closest point says little about the place along the
/// surface.
class FeatureTargets : public CorrespondenceObjective {
 public:
  /// \param further  is used as long as this object
  /// \param own  features of the shape
  /// \param map  the present map of the shape
  FeatureTargets(const CorrespondenceObjective& further, const VertexMap<Vec2>& own, const TorusMap& map,
                 const FeatureField& field, const TorusLocator& locator,
                 const FeatureTargetsOptions& options);
  Term term(VertexId v, const Vec2& plane_position) const override;

 private:
  struct Linear {
    Vec2 place;  // x0
    Mat2 slopes;
    Vec2 difference;  // f(x0) - f_v
    double weight;
  };
  const CorrespondenceObjective& further_;
  LatticeReducer reducer_;
  std::vector<Linear> linear_;
};

}  // namespace foramen
