#pragma once
/// \file
/// A model with one mode whose shapes are known in closed form.

#include "foramen/core/geometry.hpp"
#include "foramen/evaluate/generalization.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen::testing {

/// A member of the family, in the model's own coordinates: its points are linear in the strength.
inline TriangleSoup member(double strength) { return lopsided_torus_soup(60, 30, strength); }

/// The model of the members with strengths 0.4, 0.7, 1, 1.3 and 1.6, without alignment. Its mean is the
/// member with strength 1.
inline ShapeModel lopsided_model() {
  std::vector<std::vector<Vec3>> shapes;
  for (int i = 0; i < 5; ++i) shapes.push_back(member(0.4 + 0.3 * i).points);
  return model_of_aligned(shapes, member(1).triangles);
}

inline RigidTransform some_pose(double angle) {
  RigidTransform pose = RigidTransform::Identity();
  pose.rotate(Eigen::AngleAxisd(angle, Vec3(1, -2, 0.5).normalized())).pretranslate(Vec3(100, -40, 7));
  return pose;
}

/// The triangles whose three points have x below the limit.
inline TriangleSoup below_x(const TriangleSoup& soup, double limit) {
  TriangleSoup part{soup.points, {}};
  for (const auto& t : soup.triangles) {
    bool inside = true;
    for (const int v : t) inside = inside && soup.points[v].x() < limit;
    if (inside) part.triangles.push_back(t);
  }
  return part;
}

inline TriangleSoup posed(TriangleSoup soup, const RigidTransform& pose) {
  for (Vec3& p : soup.points) p = pose * p;
  return soup;
}

}  // namespace foramen::testing
