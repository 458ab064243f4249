#pragma once
/// \file
/// The description length of the cohort as a correspondence energy of the map of one shape.

#include <vector>

#include "correspond/template_surface.hpp"
#include "parameterize/optimise_map.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {

/// E_v = |a(p_v) - s_v|^2 [mm^2], where s_v is the vertex and a(p) the shape's attractor
/// (description_length()) at the torus position p, interpolated over the triangles of the template. Up to a
/// factor and a constant, it is an upper bound of the cohort's description length as a function of this
/// shape's map, with equality at the map for which the attractor was computed. Decreasing it for each shape
/// therefore decreases the description length. The gradient is exact within a triangle; the Hessian is the
/// Gauss-Newton matrix.
class DescriptionObjective : public CorrespondenceObjective {
 public:
  /// \param shape  the shape in the coordinates of the attractor
  /// \param template_locator  locator of the template's mesh and map; must outlive this object
  /// \param template_map  map of the template
  /// \param attractor  one position per template vertex
  DescriptionObjective(const Mesh& shape, const TorusLocator& template_locator, const TorusMap& template_map,
                       std::vector<Vec3> attractor);
  Term term(VertexId v, const Vec2& plane_position) const override;

 private:
  const Mesh& shape_;
  const TorusLocator& locator_;
  Mat2 to_turns_;
  std::vector<Vec3> attractor_;
  // Derivative of the attractor in each triangle, mm per unit of the plane.
  FaceMap<Eigen::Matrix<double, 3, 2>> slopes_;
};

}  // namespace foramen
