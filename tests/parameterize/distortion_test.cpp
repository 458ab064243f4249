#include "parameterize/distortion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

#include <cmath>

#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {
namespace {

Vec3 random_point(Rng& rng) { return Vec3(rng.normal(), rng.normal(), rng.normal()); }

std::array<Vec3, 3> random_surface(Rng& rng) {
  return {random_point(rng), random_point(rng), random_point(rng)};
}

std::array<Vec2, 3> random_plane(Rng& rng) {
  std::array<Vec2, 3> t;
  for (Vec2& p : t) p = Vec2(rng.normal(), rng.normal());
  Vec4 q;
  q << t[1] - t[0], t[2] - t[0];
  if (doubled_area(q) < 0) std::swap(t[1], t[2]);
  return t;
}

Vec4 edges_of(const std::array<Vec2, 3>& t) {
  Vec4 q;
  q << t[1] - t[0], t[2] - t[0];
  return q;
}

Mat2 random_target(Rng& rng) {
  Mat2 to_target;
  to_target << rng.normal(), rng.normal(), rng.normal(), rng.normal();
  if (to_target.determinant() < 0) to_target.col(0).swap(to_target.col(1));
  return to_target;
}

TEST(Distortion, IsTheProductOfAngleAndAreaDistortion) {
  Rng rng(1);
  for (int k = 0; k < 200; ++k) {
    const auto surface = random_surface(rng);
    const auto plane = random_plane(rng);
    const double product = angle_distortion(surface, plane) * area_distortion(surface, plane);
    EXPECT_NEAR(distortion(rest_triangle(surface, 1), edges_of(plane)) / product, 1, 1e-9);
    EXPECT_GE(angle_distortion(surface, plane), 2 * (1 - 1e-12));
    EXPECT_GE(area_distortion(surface, plane), 2 * (1 - 1e-12));
  }
}

TEST(Distortion, IsFourForAnIsometryAndKnownForAStretch) {
  const std::array<Vec3, 3> surface{Vec3(1, 2, 3), Vec3(4, 2, 3), Vec3(2, 2, 5)};
  const double c = std::cos(0.7), s = std::sin(0.7);
  const auto turned = [&](double along, double across) {
    const auto place = [&](double x, double y) {
      return Vec2(c * along * x - s * across * y, s * along * x + c * across * y);
    };
    return std::array<Vec2, 3>{place(0, 0), place(3, 0), place(1, 2)};
  };
  // The frame of the surface triangle: x along its first side, the third corner at (1, 2).
  EXPECT_NEAR(distortion(rest_triangle(surface, 1), edges_of(turned(1, 1))), 4, 1e-13);
  EXPECT_NEAR(distortion(rest_triangle(surface, 1), edges_of(turned(2, 3))), 4 + 9 + 1.0 / 4 + 1.0 / 9,
              1e-12);
  EXPECT_NEAR(distortion(rest_triangle(surface, 2), edges_of(turned(2, 2))), 4, 1e-13);
  EXPECT_NEAR(rest_triangle(surface, 2).area, 4 * area(surface), 1e-13);
}

// The distortion with a metric equals that of the triangle mapped to a plane in which the metric is
// Euclidean.
TEST(Distortion, OnATargetIsThatOfTheTriangleCarriedThere) {
  Rng rng(4);
  for (int k = 0; k < 200; ++k) {
    RestTriangle rest = rest_triangle(random_surface(rng), 1);
    const Vec4 q = edges_of(random_plane(rng));
    const Mat2 to_target = random_target(rng);
    const Mat2 carried = to_target * Eigen::Map<const Mat2>(q.data());
    const double expected = distortion(rest, Eigen::Map<const Vec4>(carried.data()));
    rest.to_target = to_target;
    EXPECT_NEAR(distortion(rest, q) / expected, 1, 1e-9);
  }
}

TEST(Distortion, IsInfiniteWithoutPositiveArea) {
  const auto rest = rest_triangle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, 1);
  EXPECT_TRUE(std::isinf(distortion(rest, Vec4(1, 0, 2, 0))));
  EXPECT_TRUE(std::isinf(distortion(rest, Vec4(0, 1, 1, 0))));
  EXPECT_TRUE(std::isinf(distortion_term(rest, Vec4(0, 1, 1, 0)).value));
  EXPECT_TRUE(std::isinf(distortion_gradient(rest, Vec4(0, 1, 1, 0)).value));
}

// Half of the cases have a metric of the target.
TEST(DistortionTerm, AgreesWithCentralDifferences) {
  Rng rng(2);
  for (int k = 0; k < 200; ++k) {
    RestTriangle rest = rest_triangle(random_surface(rng), 1);
    if (k % 2 == 1) rest.to_target = random_target(rng);
    const Vec4 q = edges_of(random_plane(rng));
    const DistortionTerm term = distortion_term(rest, q, false);
    const DistortionGradient gradient = distortion_gradient(rest, q);
    EXPECT_NEAR(term.value / distortion(rest, q), 1, 1e-12);
    EXPECT_NEAR((gradient.gradient - term.gradient).norm() / term.gradient.norm(), 0, 1e-9);
    const double step = 1e-5 * doubled_area(q) / q.norm();
    for (int i = 0; i < 4; ++i) {
      const Vec4 d = step * Vec4::Unit(i);
      const double slope = (distortion(rest, q + d) - distortion(rest, q - d)) / (2 * step);
      EXPECT_NEAR((slope - term.gradient[i]) / term.gradient.norm(), 0, 1e-6);
      const Vec4 column =
          (distortion_gradient(rest, q + d).gradient - distortion_gradient(rest, q - d).gradient) /
          (2 * step);
      EXPECT_NEAR((column - term.hessian.col(i)).norm() / term.hessian.norm(), 0, 1e-6);
    }
  }
}

// The clamped matrix differs from the true one by the negative eigenvalue in the frame of J; with the
// identity as rest shape that is the ordinary eigen-decomposition.
TEST(DistortionTerm, ClampingRemovesExactlyTheNegativeEigenvalues) {
  const RestTriangle rest = rest_triangle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, 1);
  Rng rng(3);
  int indefinite = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec4 q = edges_of(random_plane(rng));
    const Eigen::SelfAdjointEigenSolver<Mat4> exact(distortion_term(rest, q, false).hessian);
    const Vec4 kept = exact.eigenvalues().cwiseMax(0);
    if (exact.eigenvalues()[0] < 0) ++indefinite;
    const Mat4 expected = exact.eigenvectors() * kept.asDiagonal() * exact.eigenvectors().transpose();
    EXPECT_NEAR((distortion_term(rest, q).hessian - expected).norm() / expected.norm(), 0, 1e-9);
  }
  EXPECT_GT(indefinite, 20);
}

// With damping between 0 and 1, the Hessian is a mixture of the clamped and the true one. If nothing is
// clamped, both are equal.
TEST(DistortionTerm, DampingMixesTheClampedAndTheTrueHessian) {
  Rng rng(5);
  int indefinite = 0;
  for (int k = 0; k < 200; ++k) {
    const RestTriangle rest = rest_triangle(random_surface(rng), 1);
    const Vec4 q = edges_of(random_plane(rng));
    const DistortionTerm exact = distortion_term(rest, q, false), clamped = distortion_term(rest, q);
    if ((exact.hessian - clamped.hessian).norm() > 1e-9 * exact.hessian.norm()) ++indefinite;
    for (const double kept : {0.0, 0.3, 1.0}) {
      const DistortionTerm damped = damped_distortion_term(rest, q, kept);
      const Mat4 expected = kept * exact.hessian + (1 - kept) * clamped.hessian;
      EXPECT_NEAR((damped.hessian - expected).norm() / expected.norm(), 0, 1e-12);
      EXPECT_EQ(damped.value, exact.value);
      EXPECT_EQ(damped.gradient, exact.gradient);
    }
  }
  EXPECT_GT(indefinite, 20);
}

TEST(DistortionTerm, IsFiniteWhereSingularValuesCoincide) {
  const RestTriangle rest = rest_triangle({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}, 1);
  const DistortionTerm term = distortion_term(rest, Vec4(1, 0, 0, 1));
  EXPECT_EQ(term.value, 4);
  EXPECT_EQ(term.gradient, Vec4::Zero());
  const Eigen::SelfAdjointEigenSolver<Mat4> eigen(
      term.hessian);  // three eigenvalues 2 + 6, and 0 for the rotation
  EXPECT_NEAR((eigen.eigenvalues() - Vec4(0, 8, 8, 8)).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace foramen
