#include "correspond/template_metric.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"

namespace foramen {

TemplateMetric::TemplateMetric(const TemplateSurface& surface)
    : locator_(surface.mesh, surface.map),
      tensors_(metric_tensors(surface)),
      area_(total_area(surface.mesh)) {}

TargetMetric TemplateMetric::at(const Mesh& shape, const TorusMap& map) const {
  TargetMetric metric{FaceMap<Mat2>(shape.face_count(), Mat2::Identity()), area_};
  const Mat2 to_turns = map.lattice.inverse();
  for (FaceId f : shape.faces()) {
    const auto plane = plane_triangle(shape, map, f);
    const Vec2 centroid = to_turns * (plane[0] + plane[1] + plane[2]) / 3;
    const Mat2 tensor = interpolated(locator_.mesh(), tensors_, locator_.locate(centroid));
    metric.to_target[f] = tensor.llt().matrixU();  // U^T U = tensor
  }
  return metric;
}

}  // namespace foramen
