#include "foramen/apply/shape_distribution.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/match/bending_options.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

Eigen::MatrixXd covariance(const Eigen::MatrixXd& factor) { return factor * factor.transpose(); }

ShapeModel small_model() { return align_cohort(testing::torus_cohort(), ScaleMode::keep).model; }

TEST(ShapeDistribution, OfAModelHasItsCovariance) {
  const ShapeModel model = small_model();
  const ShapeDistribution all = distribution_of(model);
  const Eigen::MatrixXd expected = model.basis() * model.variance().asDiagonal() * model.basis().transpose();
  EXPECT_LT((covariance(all.factor) - expected).norm(), 1e-9 * expected.norm());
  const std::vector<double> deviations = standard_deviations(all);
  EXPECT_NEAR(deviations.at(7), std::sqrt(expected.diagonal().segment<3>(21).sum()), 1e-9);
}

TEST(ShapeDistribution, ColumnsAddTheirCovariance) {
  const ShapeDistribution all = distribution_of(small_model());
  const Eigen::MatrixXd more = 0.3 * Eigen::MatrixXd::Ones(all.mean.size(), 2);
  EXPECT_LT((covariance(with_columns(all, more).factor) - covariance(all.factor) - covariance(more)).norm(),
            1e-9);
}

// Any factor of a covariance gives the model of this covariance. Here, the factor is that of the modes times
// a rotation.
TEST(ShapeDistribution, ItsPrincipalModelIsTheModelAgain) {
  const ShapeModel model = small_model();
  ShapeDistribution mixed = distribution_of(model);
  for (Eigen::Index k = 1; k < mixed.factor.cols(); ++k) {
    const Eigen::VectorXd a = mixed.factor.col(k - 1), b = mixed.factor.col(k);
    mixed.factor.col(k - 1) = 0.6 * a + 0.8 * b;
    mixed.factor.col(k) = -0.8 * a + 0.6 * b;
  }
  const ShapeModel again = principal_model(mixed, model.triangles());
  ASSERT_EQ(again.modes(), model.modes());
  EXPECT_TRUE(again.variance().isApprox(model.variance(), 1e-9));
  EXPECT_TRUE(again.basis().isApprox(model.basis(), 1e-6));
  EXPECT_EQ(again.mean(), model.mean());
}

// The covariance of a coordinate at two landmarks is that of the kernel, except for what the truncated basis
// leaves out. Different coordinates are independent.
TEST(ShapeDistribution, SmoothColumnsHaveTheKernelsCovariance) {
  const ShapeModel model = small_model();
  const SmoothDisplacementOptions options{.scales = {{30, 2}}, .left_out_mm = 0.01};
  const Eigen::MatrixXd all = covariance(smooth_columns(model.mean(), 0.25, options));
  for (const int i : {0, 20, 77})
    for (const int k : {0, 5, 100}) {
      const double r = (model.mean().segment<3>(3 * i) - model.mean().segment<3>(3 * k)).norm();
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(all(3 * i + c, 3 * k + c), 0.25 * 4 * std::exp(-r * r / 1800), 1e-2);
      EXPECT_EQ(all(3 * i, 3 * k + 1), 0);
    }
  EXPECT_THROW(smooth_columns(model.mean(), 0, options), InvalidInput);
}

}  // namespace
}  // namespace foramen
