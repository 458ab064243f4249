#pragma once
/// \file
/// The description length of the whole cohort as a pull on the map of one shape.

#include <vector>

#include "correspond/template_surface.hpp"
#include "parameterize/optimise_map.hpp"
#include "sampling/lift_to_surface.hpp"

namespace foramen {

/// E_v = |a(p_v) - s_v|^2 [mm^2]: s_v the vertex, a(p) the shape's attractor (description_length()) at the
/// torus position p, interpolated over the template's triangles. A bound from above of the cohort's
/// description length as a function of this shape's map, touching it where the attractor was computed, so
/// that lowering it for all shapes in turn lowers the description length. Gradient exact within a triangle;
/// the Hessian is Gauss-Newton's.
class DescriptionObjective : public CorrespondenceObjective {
 public:
  /// \param shape  in the coordinates of the attractor  \param template_locator  of the template's mesh and
  /// map, which must outlive this  \param attractor  a place for every template vertex
  DescriptionObjective(const Mesh& shape, const TorusLocator& template_locator, const TorusMap& template_map,
                       std::vector<Vec3> attractor);
  Term term(VertexId v, const Vec2& plane_position) const override;

 private:
  const Mesh& shape_;
  const TorusLocator& locator_;
  Mat2 to_turns_;
  std::vector<Vec3> attractor_;
  FaceMap<Eigen::Matrix<double, 3, 2>> slopes_;  // of the attractor over each triangle, mm per plane unit
};

}  // namespace foramen
