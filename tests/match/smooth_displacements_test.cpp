#include "match/smooth_displacements.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/match/bending_options.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

std::vector<Vec3> points() { return testing::torus_soup(24, 12).points; }

double covariance(const SmoothDisplacementOptions& options, const Vec3& a, const Vec3& b) {
  double sum = 0;
  for (const DisplacementScale& s : options.scales)
    sum +=
        s.amplitude_mm * s.amplitude_mm * std::exp(-(a - b).squaredNorm() / (2 * s.length_mm * s.length_mm));
  return sum;
}

TEST(SmoothDisplacements, HaveTheCovarianceAskedFor) {
  const auto x = points();
  const SmoothDisplacementOptions options{.scales = {{15, 2}, {6, 1}}, .left_out_mm = 0.1};
  const Eigen::MatrixXd phi =
      smooth_displacements(x, options).rightCols(smooth_displacements(x, options).cols() - 4);
  const Eigen::MatrixXd got = phi * phi.transpose();
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j)
      EXPECT_NEAR(got(static_cast<int>(i), static_cast<int>(j)), covariance(options, x[i], x[j]),
                  options.left_out_mm * options.left_out_mm + 1e-9);
}

TEST(SmoothDisplacements, StrongestFirstAfterTheAffineOnes) {
  const Eigen::MatrixXd phi = smooth_displacements(points());
  for (int k = 5; k < phi.cols(); ++k) EXPECT_LE(phi.col(k).norm(), phi.col(k - 1).norm() * (1 + 1e-9));
  EXPECT_TRUE(phi.col(0).isConstant(10));
}

TEST(SmoothDisplacements, TheProcessDoesNotDependOnPoseOrOrder) {
  const auto x = points();
  std::vector<Vec3> moved;
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()));
  motion.pretranslate(Vec3(40, -3, 8));
  for (auto p = x.rbegin(); p != x.rend(); ++p) moved.push_back(motion * *p);
  const Eigen::MatrixXd a = smooth_displacements(x), b = smooth_displacements(moved);
  const Eigen::MatrixXd here = a * a.transpose(), there = b * b.transpose();
  const double left_out = SmoothDisplacementOptions{}.left_out_mm;
  EXPECT_LE((here - there.reverse()).cwiseAbs().maxCoeff(), 2 * left_out * left_out);
}

TEST(SmoothDisplacements, RefusesOptionsOutOfRange) {
  const auto x = points();
  EXPECT_THROW(smooth_displacements({}), InvalidInput);
  EXPECT_THROW(smooth_displacements(x, {.scales = {}}), InvalidInput);
  EXPECT_THROW(smooth_displacements(x, {.scales = {{0, 1}}}), InvalidInput);
  EXPECT_THROW(smooth_displacements(x, {.shift_mm = 0}), InvalidInput);
  EXPECT_THROW(smooth_displacements(x, {.left_out_mm = 0}), InvalidInput);
  EXPECT_THROW(smooth_displacements(x, {.most_functions = 0}), InvalidInput);
}

}  // namespace
}  // namespace foramen
