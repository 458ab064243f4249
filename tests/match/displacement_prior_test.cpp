#include "foramen/match/displacement_prior.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

TEST(DisplacementPrior, IsTheSmoothProcessUnlessToldOtherwise) {
  const PriorForm form = prior_form({}, 6);
  EXPECT_TRUE(form.precision.isIdentity(0));
  EXPECT_TRUE(form.pull.isZero(0));
}

TEST(DisplacementPrior, IsTheInverseOfTheCovariance) {
  Eigen::MatrixXd directions(6, 2);
  directions << 1, 0, 2, -1, 0, 3, 0.5, 0.5, -1, 1, 4, 0;
  const Eigen::VectorXd mean = Eigen::VectorXd::LinSpaced(6, -1, 2);
  for (const double variance : {0.02, 1.0, 7.0}) {
    const Eigen::MatrixXd covariance =
        variance * Eigen::MatrixXd::Identity(6, 6) + directions * directions.transpose();
    const PriorForm form = prior_form({variance, mean, directions}, 6);
    EXPECT_TRUE((form.precision * covariance).isIdentity(1e-11));
    EXPECT_TRUE((covariance * form.pull).isApprox(mean, 1e-11));
  }
}

TEST(DisplacementPrior, RefusesWhatDoesNotFit) {
  EXPECT_THROW(prior_form({.variance = 0}, 6), InvalidInput);
  EXPECT_THROW(prior_form({.mean = Eigen::VectorXd::Zero(5)}, 6), InvalidInput);
  EXPECT_THROW(prior_form({.directions = Eigen::MatrixXd::Zero(3, 1)}, 6), InvalidInput);
}

}  // namespace
}  // namespace foramen
