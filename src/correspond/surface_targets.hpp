#pragma once
/// \file
/// Every vertex of a shape is drawn to the torus position of a point of the template's surface.

#include <vector>

#include "correspond/template_surface.hpp"
#include "foramen/core/options.hpp"
#include "foramen/correspond/group_options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {

/// E_v = w_v |p_v - t_v|^2 [mm^2], measured on the template by its metric at t_v, to the nearest lattice
/// translate; t_v the torus position of the point of the bent template closest to the vertex among those of
/// compatible normal (barycentric, not a vertex). Quadratic, so value, gradient and Hessian are exact.
class SurfaceTargets : public CorrespondenceObjective {
 public:
  /// \param bent  where the template's vertices are once it is bent onto the shape, in the shape's
  /// coordinates
  SurfaceTargets(const Mesh& shape, const TemplateSurface& surface, const VertexMap<Mat2>& tensors,
                 std::vector<Vec3> bent, const SurfaceTargetsOptions& options = {});
  Term term(VertexId v, const Vec2& plane_position) const override;
  /// Part of the vertices that have no target.
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
