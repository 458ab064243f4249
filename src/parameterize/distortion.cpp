#include "parameterize/distortion.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

double plane_area(const std::array<Vec2, 3>& t) {
  Vec4 edges;
  edges << t[1] - t[0], t[2] - t[0];
  return doubled_area(edges) / 2;
}

// Cotangent of the angle at corner k of a triangle in space.
double cotangent(const std::array<Vec3, 3>& t, std::size_t k) {
  const Vec3 a = t[(k + 1) % 3] - t[k], b = t[(k + 2) % 3] - t[k];
  return a.dot(b) / a.cross(b).norm();
}

Mat2 jacobian(const RestTriangle& rest, const Vec4& edges) {
  return rest.to_target * Eigen::Map<const Mat2>(edges.data()) * rest.inverse;
}

double jacobian_determinant(const RestTriangle& rest, double doubled_plane_area) {
  return doubled_plane_area * rest.inverse.determinant() * rest.to_target.determinant();
}

// dE/dq from dE/dJ. Since J = T Q R with Q = q as a matrix, the inner product of M with J(q) equals that of
// T^T M R^T with q.
Vec4 along_edges(const RestTriangle& rest, const Mat2& along_jacobian) {
  const Mat2 m = rest.to_target.transpose() * along_jacobian * rest.inverse.transpose();
  return Eigen::Map<const Vec4>(m.data());
}

// The eigenmatrices of the Hessian of an isotropic energy at J, each of norm 1 (Smith, de Goes, Kim 2019).
// They are computed without a singular value decomposition: as a map of the complex plane, J is z -> alpha z
// + beta conj(z) with 2|alpha| = s1 + s2 and 2|beta| = s1 - s2.
struct Eigenmatrices {
  double s1, s2;  // singular values, s1 >= s2 > 0
  Mat2 stretch1, stretch2, twist, flip;
};

Eigenmatrices eigenmatrices(const Mat2& j, double det) {
  const Vec2 alpha(j(0, 0) + j(1, 1), j(1, 0) - j(0, 1)), beta(j(0, 0) - j(1, 1), j(1, 0) + j(0, 1));
  const double sum = alpha.norm(), difference = beta.norm();
  const Vec2 a = alpha / sum;
  // For s1 = s2 any direction is correct, because all eigenvalues except that of the twist are equal there.
  const Vec2 b = difference > 0 ? Vec2(beta / difference) : Vec2(1, 0);
  Mat2 rotation, reflection;
  rotation << a.x(), -a.y(), a.y(), a.x();
  reflection << b.x(), b.y(), b.y(), -b.x();
  Mat2 quarter_turn;
  quarter_turn << 0, -1, 1, 0;
  Eigenmatrices e;
  e.s1 = (sum + difference) / 2;
  e.s2 = det / e.s1;  // avoids the cancellation of (sum - difference) / 2
  e.stretch1 = (rotation + reflection) / 2;
  e.stretch2 = (rotation - reflection) / 2;
  e.twist = quarter_turn * rotation / std::numbers::sqrt2;
  e.flip = quarter_turn * reflection / std::numbers::sqrt2;
  return e;
}

}  // namespace

double angle_distortion(const std::array<Vec3, 3>& surface, const std::array<Vec2, 3>& plane) {
  const double in_plane = plane_area(plane);
  if (!(in_plane > 0)) return infinite;
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k)
    sum += (plane[(k + 2) % 3] - plane[(k + 1) % 3]).squaredNorm() * cotangent(surface, k);
  return sum / (2 * in_plane);  // [becker2011 Eq. 1]
}

double area_distortion(const std::array<Vec3, 3>& surface, const std::array<Vec2, 3>& plane) {
  const double in_plane = plane_area(plane), in_space = area(surface);
  if (!(in_plane > 0)) return infinite;
  return in_space / in_plane + in_plane / in_space;  // [becker2011 Eq. 2]
}

RestTriangle rest_triangle(const std::array<Vec3, 3>& surface, double scale) {
  const Vec3 a = scale * (surface[1] - surface[0]), b = scale * (surface[2] - surface[0]);
  const double base = a.norm(), doubled = a.cross(b).norm(), height = doubled / base;
  RestTriangle rest;
  // The inverse of [a b] in the frame whose first axis is along a.
  rest.inverse << 1 / base, -a.dot(b) / (base * doubled), 0, 1 / height;
  rest.area = doubled / 2;
  return rest;
}

double distortion(const RestTriangle& rest, const Vec4& edges) {
  const double doubled = doubled_area(edges);
  if (!(doubled > 0)) return infinite;
  const double det = jacobian_determinant(rest, doubled);
  return jacobian(rest, edges).squaredNorm() * (1 + 1 / (det * det));
}

DistortionGradient distortion_gradient(const RestTriangle& rest, const Vec4& edges) {
  const double doubled = doubled_area(edges);
  if (!(doubled > 0)) return {infinite, Vec4::Zero()};
  const double det = jacobian_determinant(rest, doubled);
  const Mat2 j = jacobian(rest, edges);
  Mat2 cofactor;
  cofactor << j(1, 1), -j(1, 0), -j(0, 1), j(0, 0);
  const double norm = j.squaredNorm(), factor = 1 + 1 / (det * det);
  const Mat2 along_jacobian = 2 * factor * j - (2 * norm / (det * det * det)) * cofactor;
  return {norm * factor, along_edges(rest, along_jacobian)};
}

DistortionTerm distortion_term(const RestTriangle& rest, const Vec4& edges, bool clamp) {
  return damped_distortion_term(rest, edges, clamp ? 0.0 : 1.0);
}

DistortionTerm damped_distortion_term(const RestTriangle& rest, const Vec4& edges, double kept) {
  DistortionTerm term;
  const double doubled = doubled_area(edges);
  if (!(doubled > 0)) {
    term.value = infinite;
    return term;
  }
  const double det = jacobian_determinant(rest, doubled);
  const Mat2 j = jacobian(rest, edges);
  const Eigenmatrices e = eigenmatrices(j, det);
  const double norm = j.squaredNorm(), cubed = det * det * det;
  const double i1 = 1 / (e.s1 * e.s1), i2 = 1 / (e.s2 * e.s2);  // E = s1^2 + s2^2 + 1/s1^2 + 1/s2^2
  const double slope1 = 2 * (e.s1 - i1 / e.s1), slope2 = 2 * (e.s2 - i2 / e.s2);
  const double true_twist = 2 - 2 * (norm - det) / cubed;  // the only eigenvalue that can be negative
  const double twist = true_twist < 0 ? kept * true_twist : true_twist;
  const double flip = 2 + 2 * (norm + det) / cubed;

  const Vec4 stretch1 = along_edges(rest, e.stretch1), stretch2 = along_edges(rest, e.stretch2);
  const Vec4 twisting = along_edges(rest, e.twist), flipping = along_edges(rest, e.flip);
  term.value = norm * (1 + 1 / (det * det));
  term.gradient = slope1 * stretch1 + slope2 * stretch2;
  term.hessian.noalias() = (2 + 6 * i1 * i1) * stretch1 * stretch1.transpose();
  term.hessian.noalias() += (2 + 6 * i2 * i2) * stretch2 * stretch2.transpose();
  term.hessian.noalias() += flip * flipping * flipping.transpose();
  term.hessian.noalias() += twist * twisting * twisting.transpose();
  return term;
}

}  // namespace foramen
