#pragma once
/// \file
/// The distortion of one triangle under the map surface -> plane (after Degener et al.): the product of
/// [becker2011 Eq. 1] and [becker2011 Eq. 2].

#include <array>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// E_angle = (a^2 cot alpha + b^2 cot beta + c^2 cot gamma) / (2 area(T)): >= 2, 2 iff angles are preserved.
/// [becker2011 Eq. 1]
double angle_distortion(const std::array<Vec3, 3>& surface, const std::array<Vec2, 3>& plane);
/// E_area = area(T3D)/area(T) + area(T)/area(T3D): >= 2, 2 iff the area is preserved. Both areas are in the
/// same unit. [becker2011 Eq. 2]
double area_distortion(const std::array<Vec3, 3>& surface, const std::array<Vec2, 3>& plane);

/// The inverted rest shape of a surface triangle in its own plane. The Jacobian of the map is J = to_target
/// [x1 - x0, x2 - x0] inverse.
struct RestTriangle {
  Mat2 inverse;     ///< 1 / length
  double area = 0;  ///< scaled surface area
  /// Maps plane vectors to the plane in which distortion is measured; the identity without a target metric.
  /// det > 0.
  Mat2 to_target = Mat2::Identity();
};
/// \param scale  factor of lengths that gives the whole surface the area of the domain
RestTriangle rest_triangle(const std::array<Vec3, 3>& surface, double scale);

using Mat4 = Eigen::Matrix4d;
using Vec4 = Eigen::Vector4d;
/// Twice the signed area of the plane triangle with edge vectors q = (x1 - x0, x2 - x0). All code tests
/// whether an area is positive by this expression, so that different functions cannot disagree about a
/// triangle because of rounding.
inline double doubled_area(const Vec4& edges) { return edges[0] * edges[3] - edges[1] * edges[2]; }

/// E = E_angle E_area = |J|^2 + |J^-1|^2 as a function of the two edge vectors q = (x1 - x0, x2 - x0) in R^4;
/// >= 4, +inf if det J <= 0.
struct DistortionTerm {
  double value = 0;
  Vec4 gradient = Vec4::Zero();
  /// Made positive semi-definite by clamping the eigenvalues of its closed-form decomposition.
  Mat4 hessian = Mat4::Zero();
};
double distortion(const RestTriangle& rest, const Vec4& edges);
struct DistortionGradient {
  double value = 0;
  Vec4 gradient = Vec4::Zero();
};
DistortionGradient distortion_gradient(const RestTriangle& rest, const Vec4& edges);
DistortionTerm distortion_term(const RestTriangle& rest, const Vec4& edges, bool clamp = true);
/// Between the clamped and the true Hessian: the only eigenvalue that can be negative is multiplied by `kept`
/// if it is negative. kept = 0 gives the clamped and kept = 1 the true Hessian.
DistortionTerm damped_distortion_term(const RestTriangle& rest, const Vec4& edges, double kept);

}  // namespace foramen
