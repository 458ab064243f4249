#pragma once
/// \file
/// Motions of a small region of space, which leave what is far away at rest.

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::synth {

/// \f$ v(x) = e^{-(x - c)^T M (x - c) / 2} \, (s + A (x - p)) \f$: an affine velocity within a Gaussian
/// window.
struct LocalMotion {
  Vec3 centre;                 ///< c, where the window is 1
  Mat3 precision;              ///< M, the inverse covariance of the window [1/mm^2]
  Vec3 pivot = Vec3::Zero();   ///< p, the point that A leaves at rest
  Vec3 shift = Vec3::Zero();   ///< s [mm per unit of time]
  Mat3 linear = Mat3::Zero();  ///< A [1 per unit of time]

  Vec3 operator()(const Vec3& point) const;
};

/// The sum of local motions.
struct LocalMotions {
  std::vector<LocalMotion> all;

  Vec3 operator()(const Vec3& point) const;
};

/// The precision of a window with these standard deviations along the columns of `axes`.
Mat3 window_precision(const Mat3& axes, const Vec3& deviations_mm);

/// The mirror image at the plane x = 0, which changes left and right.
LocalMotion mirrored(const LocalMotion& motion);

}  // namespace foramen::synth
