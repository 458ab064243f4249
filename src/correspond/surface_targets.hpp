#pragma once
/// \file
/// A correspondence energy that attracts every vertex of a shape to the torus position of a point on the
/// template.

#include <vector>

#include "correspond/template_surface.hpp"
#include "foramen/core/options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// E_v = w_v |p_v - t_v|^2 [mm^2], where the distance is measured to the nearest lattice translate in the
/// metric of the template at t_v. The target t_v is the torus position of the surface point of the bent
/// template that is closest to the vertex among the points with compatible normals. The weight w_v is Tukey's
/// biweight of the distance between the vertex and that surface point (reach_mm). The term is quadratic, so
/// value, gradient and Hessian are exact.
class SurfaceTargets : public CorrespondenceObjective {
 public:
  /// \param bent  positions of the template's vertices after bending, in the coordinates of the shape
  SurfaceTargets(const Mesh& shape, const TemplateSurface& surface, const VertexMap<Mat2>& tensors,
                 std::vector<Vec3> bent, const SurfaceTargetsOptions& options = {});
  Term term(VertexId v, const Vec2& plane_position) const override;
  /// Share of the vertices that have no target.
  double share_without() const;

 private:
  struct Target {
    Vec2 position = Vec2::Zero();  // in the plane
    Mat2 weight = Mat2::Zero();    // w G
  };
  LatticeReducer reducer_;
  std::vector<Target> targets_;  // per vertex
};

}  // namespace foramen
