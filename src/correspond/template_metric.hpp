#pragma once
/// \file
/// The metric of the template, in which distortion is measured instead of in the flat torus.

#include "correspond/template_surface.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "parameterize/optimise_map.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {

/// Provides the TargetMetric with which the distortion of a shape's map is that of the map shape -> template.
/// It is made from metric_tensors().
class TemplateMetric {
 public:
  explicit TemplateMetric(const TemplateSurface& surface);
  /// The metric for each triangle of the shape, at the position of its centroid in this map. It must be
  /// computed again if the map changes by much.
  TargetMetric at(const Mesh& shape, const TorusMap& map) const;
  const VertexMap<Mat2>& tensors() const { return tensors_; }
  const TorusLocator& locator() const { return locator_; }

 private:
  TorusLocator locator_;
  VertexMap<Mat2> tensors_;
  double area_;
};

}  // namespace foramen
