#include "correspond/description_objective.hpp"

#include <utility>

#include <Eigen/LU>

#include "foramen/core/error.hpp"

namespace foramen {

DescriptionObjective::DescriptionObjective(const Mesh& shape, const TorusLocator& template_locator,
                                           const TorusMap& template_map, std::vector<Vec3> attractor)
    : shape_(shape),
      locator_(template_locator),
      to_turns_(template_map.lattice.inverse()),
      attractor_(std::move(attractor)),
      slopes_(template_locator.mesh().face_count(), Eigen::Matrix<double, 3, 2>::Zero()) {
  const Mesh& surface = locator_.mesh();
  FORAMEN_ASSERT(static_cast<int>(attractor_.size()) == surface.vertex_count());
  for (FaceId f : surface.faces()) {
    const auto plane = plane_triangle(surface, template_map, f);
    const auto c = surface.corners(f);
    const auto at = [&](std::size_t k) { return attractor_[c[k].index]; };
    Mat2 edges;
    edges << plane[1] - plane[0], plane[2] - plane[0];
    Eigen::Matrix<double, 3, 2> sides;
    sides << at(1) - at(0), at(2) - at(0);
    slopes_[f] = sides * edges.inverse();
  }
}

CorrespondenceObjective::Term DescriptionObjective::term(VertexId v, const Vec2& plane_position) const {
  const SurfacePoint place = locator_.locate(Vec2(to_turns_ * plane_position));
  const auto c = locator_.mesh().corners(place.face);
  Vec3 residual = -shape_.position(v);
  for (std::size_t k = 0; k < 3; ++k)
    residual += place.barycentric[static_cast<Eigen::Index>(k)] * attractor_[c[k].index];
  const Eigen::Matrix<double, 3, 2>& slope = slopes_[place.face];
  return {residual.squaredNorm(), 2 * slope.transpose() * residual, 2 * slope.transpose() * slope};
}

}  // namespace foramen
