#include "synth/solids.hpp"

#include <algorithm>
#include <cmath>

namespace foramen::synth {

namespace {

// Distance from a rectangle that is offset by a radius, as a function of the excesses over its half sides,
// with its derivatives.
struct Excess {
  double value, d_first, d_second;
};
Excess rounded_corner(double first, double second, double radius) {
  if (first <= 0 && second <= 0) {
    return first > second ? Excess{first - radius, 1, 0} : Excess{second - radius, 0, 1};
  }
  const double u = std::max(first, 0.0), v = std::max(second, 0.0), length = std::sqrt(u * u + v * v);
  return {length - radius, u / length, v / length};
}

}  // namespace

Jet Plate::distance(const Vec3& p) const {
  const Vec3 local = axes.transpose() * (p - centre), away = local.cwiseAbs();
  const Excess outline =
      rounded_corner(away[0] - (half[0] - corner_radius), away[1] - (half[1] - corner_radius), corner_radius);
  const Excess solid =
      rounded_corner(outline.value + edge_radius, away[2] - (half[2] - edge_radius), edge_radius);
  Vec3 gradient(solid.d_first * outline.d_first, solid.d_first * outline.d_second, solid.d_second);
  for (int k = 0; k < 3; ++k)
    if (local[k] < 0) gradient[k] = -gradient[k];
  return {solid.value, axes * gradient};
}

Jet Capsule::distance(const Vec3& p) const {
  const Vec3 axis = to - from;
  const double squared = axis.squaredNorm();
  const double t = std::clamp((p - from).dot(axis) / squared, 0.0, 1.0);
  const Vec3 away = p - (from + t * axis);
  const double length = away.norm();
  // The derivative of the smooth step is zero at the ends, so the surface has no crease there.
  const double radius = radius_from + (radius_to - radius_from) * t * t * (3 - 2 * t);
  const double widening = (radius_to - radius_from) * 6 * t * (1 - t);
  const Vec3 direction = length > 0 ? Vec3(away / length) : Vec3(Vec3::Zero());
  return {length - radius, direction - widening / squared * axis};
}

Mat3 frame(const Vec3& first, const Vec3& second) {
  Mat3 axes;
  axes.col(0) = first.normalized();
  axes.col(1) = (second - second.dot(axes.col(0)) * axes.col(0)).normalized();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  return axes;
}

}  // namespace foramen::synth
