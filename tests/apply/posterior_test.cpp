#include "apply/posterior.hpp"

#include <gtest/gtest.h>
#include <Eigen/LU>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

constexpr int landmarks = 6, columns = 4;

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index cols, Rng& rng) {
  Eigen::MatrixXd m(rows, cols);
  for (double& x : m.reshaped()) x = rng.normal();
  return m;
}

ShapeDistribution random_distribution(std::uint64_t seed) {
  Rng rng(seed);
  return {random_matrix(3 * landmarks, 1, rng), random_matrix(3 * landmarks, columns, rng)};
}

Mat3 random_precision(Rng& rng) {
  const Mat3 root = random_matrix(3, 3, rng);
  return root * root.transpose() + 0.1 * Mat3::Identity();
}

std::vector<LandmarkObservation> random_observations(std::uint64_t seed) {
  Rng rng(seed);
  std::vector<LandmarkObservation> all;
  for (const int landmark : {4, 1})
    all.push_back({landmark, Vec3(rng.normal(), rng.normal(), rng.normal()), random_precision(rng)});
  return all;
}

Eigen::MatrixXd covariance(const ShapeDistribution& d) { return d.factor * d.factor.transpose(); }

// The reference: the conditional of a joint normal distribution, computed by the textbook formula.
struct Conditional {
  Eigen::VectorXd mean;
  Eigen::MatrixXd covariance;
};
Conditional dense_conditional(const ShapeDistribution& prior,
                              const std::vector<LandmarkObservation>& observations) {
  const auto count = static_cast<Eigen::Index>(3 * observations.size());
  Eigen::MatrixXd pick = Eigen::MatrixXd::Zero(count, prior.mean.size());
  Eigen::MatrixXd noise = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd place(count);
  for (std::size_t k = 0; k < observations.size(); ++k) {
    const auto row = static_cast<Eigen::Index>(3 * k);
    pick.block<3, 3>(row, 3 * observations[k].landmark).setIdentity();
    noise.block<3, 3>(row, row) = observations[k].precision.inverse();
    place.segment<3>(row) = observations[k].place;
  }
  const Eigen::MatrixXd all = covariance(prior);
  const Eigen::MatrixXd gain = all * pick.transpose() * (pick * all * pick.transpose() + noise).inverse();
  return {prior.mean + gain * (place - pick * prior.mean), all - gain * pick * all};
}

TEST(Posterior, IsTheConditionalOfTheJointDistribution) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const ShapeDistribution prior = random_distribution(seed);
    const auto observations = random_observations(100 + seed);
    const Conditional expected = dense_conditional(prior, observations);
    const ShapeDistribution given = posterior(prior, posterior_coefficients(prior, observations));
    EXPECT_LT((given.mean - expected.mean).norm(), 1e-9);
    EXPECT_LT((covariance(given) - expected.covariance).norm(), 1e-9);
  }
}

// Albrecht et al. have M = Q^T Q + sigma^2 I, with the same sigma for all landmarks.
TEST(Posterior, IsThePapersFormForACommonNoise) {
  constexpr double sigma = 0.7;
  const ShapeDistribution prior = random_distribution(3);
  std::vector<LandmarkObservation> observations = random_observations(4);
  for (LandmarkObservation& o : observations) o.precision = Mat3::Identity() / (sigma * sigma);
  Eigen::MatrixXd q(6, columns);
  Eigen::VectorXd difference(6);
  for (int k = 0; k < 2; ++k) {
    const LandmarkObservation& o = observations[k];
    q.middleRows<3>(3 * k) = prior.factor.middleRows<3>(3 * o.landmark);
    difference.segment<3>(3 * k) = o.place - prior.mean.segment<3>(3 * o.landmark);
  }
  const Eigen::MatrixXd m = q.transpose() * q + sigma * sigma * Eigen::MatrixXd::Identity(columns, columns);
  const PosteriorCoefficients given = posterior_coefficients(prior, observations);
  EXPECT_LT((given.mean - m.inverse() * q.transpose() * difference).norm(), 1e-12);
  EXPECT_LT((given.spread * given.spread.transpose() - sigma * sigma * m.inverse()).norm(), 1e-12);
}

TEST(Posterior, WithoutObservationsIsThePrior) {
  const ShapeDistribution prior = random_distribution(5);
  const ShapeDistribution given = posterior(prior, posterior_coefficients(prior, {}));
  EXPECT_EQ(given.mean, prior.mean);
  EXPECT_LT((covariance(given) - covariance(prior)).norm(), 1e-12);
}

TEST(Posterior, AnObservationGivenTwiceHasTwiceThePrecision) {
  const ShapeDistribution prior = random_distribution(6);
  std::vector<LandmarkObservation> once = random_observations(7);
  std::vector<LandmarkObservation> twice = once;
  twice.insert(twice.end(), once.begin(), once.end());
  for (LandmarkObservation& o : once) o.precision *= 2;
  EXPECT_LT((posterior_coefficients(prior, once).mean - posterior_coefficients(prior, twice).mean).norm(),
            1e-12);
}

TEST(Posterior, AnObservationAcrossAPlaneLeavesMotionAlongItFree) {
  // One landmark with a prior in all directions. The match moves it across the plane to the observed place,
  // and not along the plane.
  const ShapeDistribution prior{Eigen::Vector3d(1, 2, 3), Eigen::Matrix3d::Identity()};
  const Vec3 normal = Vec3(1, 2, 2) / 3;
  const std::vector<LandmarkObservation> seen{{0, Vec3(5, 5, 5), 1e8 * normal * normal.transpose()}};
  const ShapeDistribution given = posterior(prior, posterior_coefficients(prior, seen));
  const Vec3 moved = given.mean - prior.mean;
  EXPECT_NEAR(moved.dot(normal), (Vec3(5, 5, 5) - prior.mean).dot(normal), 1e-6);
  EXPECT_LT(moved.cross(normal).norm(), 1e-6);
  EXPECT_NEAR(standard_deviations(given).at(0), std::sqrt(2.0), 1e-6);
}

TEST(Posterior, TurnsWithTheSpace) {
  const ShapeDistribution prior = random_distribution(8);
  const auto observations = random_observations(9);
  const Mat3 turn = Eigen::AngleAxisd(0.8, Vec3(1, -2, 3).normalized()).toRotationMatrix();
  ShapeDistribution turned = prior;
  for (int i = 0; i < landmarks; ++i) {
    turned.mean.segment<3>(3 * i) = turn * prior.mean.segment<3>(3 * i);
    turned.factor.middleRows<3>(3 * i) = turn * prior.factor.middleRows<3>(3 * i);
  }
  auto turned_observations = observations;
  for (LandmarkObservation& o : turned_observations) {
    o.place = turn * o.place;
    o.precision = turn * o.precision * turn.transpose();
  }
  EXPECT_LT((posterior_coefficients(prior, observations).mean -
             posterior_coefficients(turned, turned_observations).mean)
                .norm(),
            1e-10);
}

TEST(Posterior, RefusesALandmarkThatIsNotThere) {
  const ShapeDistribution prior = random_distribution(10);
  for (const int landmark : {-1, landmarks}) {
    const std::vector<LandmarkObservation> seen{{landmark, Vec3::Zero(), Mat3::Identity()}};
    EXPECT_THROW(posterior_coefficients(prior, seen), InvalidInput);
  }
}

}  // namespace
}  // namespace foramen
