#pragma once
/// \file
/// Distortion measured on the template in place of the flat torus.

#include "correspond/template_surface.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "parameterize/optimise_map.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {

/// Makes the energy of a shape's map that of the map shape -> template, by the template's metric_tensors().
class TemplateMetric {
 public:
  explicit TemplateMetric(const TemplateSurface& surface);
  /// The metric at the place where the centroid of each of the shape's triangles lies in this map; a map that
  /// moves far needs it again.
  TargetMetric at(const Mesh& shape, const TorusMap& map) const;
  const VertexMap<Mat2>& tensors() const { return tensors_; }
  const TorusLocator& locator() const { return locator_; }

 private:
  TorusLocator locator_;
  VertexMap<Mat2> tensors_;
  double area_;
};

}  // namespace foramen
