#include "synth/local_motion.hpp"

#include <Eigen/LU>
#include <cmath>

namespace foramen::synth {

Vec3 LocalMotion::operator()(const Vec3& point) const {
  constexpr double negligible = 40;  // the window is then below 1e-8
  const Vec3 away = point - centre;
  const double squared = away.dot(precision * away);
  if (squared > negligible) return Vec3::Zero();
  return std::exp(-0.5 * squared) * (shift + linear * (point - pivot));
}

Vec3 LocalMotions::operator()(const Vec3& point) const {
  Vec3 sum = Vec3::Zero();
  for (const LocalMotion& motion : all) sum += motion(point);
  return sum;
}

Mat3 window_precision(const Mat3& axes, const Vec3& deviations_mm) {
  return axes * deviations_mm.cwiseAbs2().cwiseInverse().asDiagonal() * axes.transpose();
}

LocalMotion mirrored(const LocalMotion& motion) {
  const Vec3 signs(-1, 1, 1);
  const auto of_vector = [&](const Vec3& v) { return Vec3(signs.cwiseProduct(v)); };
  const auto of_matrix = [&](const Mat3& m) { return Mat3(signs.asDiagonal() * m * signs.asDiagonal()); };
  return {of_vector(motion.centre), of_matrix(motion.precision), of_vector(motion.pivot),
          of_vector(motion.shift), of_matrix(motion.linear)};
}

}  // namespace foramen::synth
