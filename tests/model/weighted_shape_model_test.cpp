// The shape model in the inner product of landmark weights.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/model/procrustes.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {
namespace {

using Shapes = std::vector<std::vector<Vec3>>;

Shapes random_shapes(int count, int landmarks, std::uint64_t seed) {
  Rng rng(seed);
  Shapes shapes(count);
  for (auto& shape : shapes)
    for (int i = 0; i < landmarks; ++i)
      shape.emplace_back(20 + i + rng.normal(), -3.0 * i + rng.normal(), 2 * rng.normal());
  return shapes;
}

std::vector<double> random_weights(std::size_t count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<double> weights;
  for (std::size_t i = 0; i < count; ++i) weights.push_back(rng.uniform(0.1, 3));
  return weights;
}

/// The diagonal of W in the inner product x^T W y.
Eigen::VectorXd per_coordinate(const std::vector<double>& weights) {
  Eigen::VectorXd w(3 * std::ssize(weights));
  for (Eigen::Index k = 0; k < w.size(); ++k) w[k] = weights[k / 3];
  return w;
}

Eigen::MatrixXd covariance_of(const ShapeModel& model) {
  return model.basis() * model.variance().asDiagonal() * model.basis().transpose();
}

TEST(WeightedShapeModel, WeightsOfOneChangeNothing) {
  const Shapes shapes = random_shapes(7, 20, 21);
  const ShapeModel plain = model_of_aligned(shapes, {});
  const ShapeModel ones = model_of_aligned(shapes, {}, std::vector<double>(20, 1.0));
  EXPECT_EQ(plain.mean(), ones.mean());
  EXPECT_EQ(plain.basis(), ones.basis());
  EXPECT_EQ(plain.variance(), ones.variance());
  EXPECT_EQ(plain.total_weight(), ones.total_weight());
  const Eigen::VectorXd a = flattened(shapes[0]), b = flattened(shapes[1]);
  EXPECT_EQ(plain.scores(a, 6), ones.scores(a, 6));
  EXPECT_NEAR(plain.landmark_rms(a, b), ones.landmark_rms(a, b), 1e-12);
}

// Modes of C in the inner product W solve W C W f = v W f with f^T W f = 1.
TEST(WeightedShapeModel, AgreesWithTheGeneralisedEigenproblem) {
  const int landmarks = 8, count = 6;
  const Shapes shapes = random_shapes(count, landmarks, 22);
  const auto weights = random_weights(landmarks, 23);
  const ShapeModel model = model_of_aligned(shapes, {}, weights);
  Eigen::MatrixXd x(3 * landmarks, count);
  for (Eigen::Index s = 0; s < count; ++s) x.col(s) = flattened(shapes[s]);
  x.colwise() -= Eigen::VectorXd(x.rowwise().mean());
  const Eigen::MatrixXd w = per_coordinate(weights).asDiagonal();
  const Eigen::MatrixXd covariance = x * x.transpose() / (count - 1);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> oracle(w * covariance * w, w);
  ASSERT_EQ(model.modes(), count - 1);
  for (int m = 0; m < model.modes(); ++m) {
    const Eigen::Index column = 3 * landmarks - 1 - m;
    EXPECT_NEAR(model.variance()[m], oracle.eigenvalues()[column], 1e-11);
    const Eigen::VectorXd mode = oracle.eigenvectors().col(column);
    EXPECT_NEAR(std::abs(mode.dot(w * model.basis().col(m))), 1, 1e-11);
  }
  EXPECT_LT((covariance_of(model) - covariance).norm(), 1e-12 * covariance.norm());
  EXPECT_NEAR(model.variance().sum(), (w * covariance).trace(), 1e-11);
}

TEST(WeightedShapeModel, ModesAreOrthonormalInTheWeightsAndSigned) {
  const auto weights = random_weights(30, 24);
  const ShapeModel model = model_of_aligned(random_shapes(9, 30, 25), {}, weights);
  const Eigen::MatrixXd gram =
      model.basis().transpose() * per_coordinate(weights).asDiagonal() * model.basis();
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(8, 8)).cwiseAbs().maxCoeff(), 1e-13);
  for (int m = 0; m < 8; ++m) EXPECT_GT(model.basis().col(m).maxCoeff(), -model.basis().col(m).minCoeff());
}

TEST(WeightedShapeModel, ScoresAreThoseOfTheClosestReconstruction) {
  const Shapes shapes = random_shapes(8, 25, 26);
  const ShapeModel model = model_of_aligned(shapes, {}, random_weights(25, 27));
  for (const auto& s : shapes)
    EXPECT_LT((model.reconstruct(model.scores(flattened(s), model.modes())) - flattened(s)).norm(), 1e-11);
  const Eigen::VectorXd shape = flattened(random_shapes(1, 25, 28)[0]), best = model.scores(shape, 4);
  const double least = model.landmark_rms(shape, model.reconstruct(best));
  for (Eigen::Index m = 0; m < 4; ++m)
    for (const double step : {-0.01, 0.01}) {
      Eigen::VectorXd other = best;
      other[m] += step;
      EXPECT_GT(model.landmark_rms(shape, model.reconstruct(other)), least);
    }
}

TEST(WeightedShapeModel, LandmarkRmsIsTheWeightedRoot) {
  const ShapeModel model(Eigen::VectorXd::Zero(6), Eigen::MatrixXd(6, 0), Eigen::VectorXd(0), {}, {1, 3});
  Eigen::VectorXd a = Eigen::VectorXd::Zero(6), b = a;
  a[0] = 2;            // first landmark 2 apart
  a[4] = 3, b[5] = 4;  // second 5
  EXPECT_DOUBLE_EQ(model.landmark_rms(a, b), std::sqrt((1 * 4 + 3 * 25) / 4.0));
  EXPECT_DOUBLE_EQ(model.total_weight(), 4);
}

// Weights can compensate for a higher density of landmarks.
TEST(WeightedShapeModel, ALandmarkTwiceWithHalfItsWeightChangesNothing) {
  const Shapes shapes = random_shapes(7, 18, 29);
  const auto weights = random_weights(18, 30);
  Shapes doubled = shapes;
  for (auto& shape : doubled) shape.push_back(shape[4]);
  auto halved = weights;
  halved[4] /= 2;
  halved.push_back(halved[4]);
  const ProcrustesResult one = procrustes(shapes, ScaleMode::remove, weights);
  const ProcrustesResult two = procrustes(doubled, ScaleMode::remove, halved);
  for (std::size_t s = 0; s < shapes.size(); ++s)
    EXPECT_LT((one.transforms[s].matrix() - two.transforms[s].matrix()).norm(), 1e-9);
  const ShapeModel a = model_of_aligned(one.aligned, {}, weights);
  const ShapeModel b = model_of_aligned(two.aligned, {}, halved);
  ASSERT_EQ(a.modes(), b.modes());
  EXPECT_NEAR(a.total_weight(), b.total_weight(), 1e-12);
  EXPECT_LT((a.variance() - b.variance()).norm(), 1e-9 * a.variance().norm());
  EXPECT_LT((a.basis() - b.basis().topRows(54)).norm(), 1e-8);
  EXPECT_LT((a.scores(flattened(one.aligned[2]), 6) - b.scores(flattened(two.aligned[2]), 6)).norm(), 1e-8);
  EXPECT_NEAR(a.landmark_rms(flattened(one.aligned[0]), a.mean()),
              b.landmark_rms(flattened(two.aligned[0]), b.mean()), 1e-9);
  // Without weights, the duplicated landmark has twice the influence.
  EXPECT_GT(
      std::abs(model_of_aligned(doubled, {}).variance()[0] - model_of_aligned(shapes, {}).variance()[0]),
      1e-3);
}

TEST(Reweighted, IsTheSameDistributionInTheModesOfTheWeights) {
  const Shapes shapes = random_shapes(8, 25, 31);
  const auto weights = random_weights(25, 32);
  const ShapeModel plain = model_of_aligned(shapes, {}), weighted = model_of_aligned(shapes, {}, weights);
  const ShapeModel there = reweighted(plain, weights), back = reweighted(there, {});
  EXPECT_EQ(there.weights(), weights);
  EXPECT_TRUE(back.weights().empty());
  EXPECT_EQ(there.mean(), plain.mean());
  EXPECT_LT((there.variance() - weighted.variance()).norm(), 1e-11 * weighted.variance().norm());
  EXPECT_LT((there.basis() - weighted.basis()).norm(), 1e-9);
  EXPECT_LT((back.basis() - plain.basis()).norm(), 1e-9);
  EXPECT_LT((covariance_of(there) - covariance_of(plain)).norm(), 1e-11 * covariance_of(plain).norm());
  const ShapeModel still(plain.mean(), Eigen::MatrixXd(75, 0), Eigen::VectorXd(0), {});
  EXPECT_EQ(reweighted(still, weights).weights(), weights);
}

TEST(WeightedShapeModel, RefusesWeightsThatAreNoInnerProduct) {
  const Shapes shapes = random_shapes(4, 10, 33);
  const ShapeModel model = model_of_aligned(shapes, {});
  std::vector<double> fewer(9, 1.0), zero(10, 1.0), negative = zero, broken = zero;
  zero[3] = 0;
  negative[3] = -1;
  broken[3] = std::numeric_limits<double>::quiet_NaN();
  for (const auto& weights : {fewer, zero, negative, broken}) {
    EXPECT_THROW(model_of_aligned(shapes, {}, weights), InvalidInput);
    EXPECT_THROW(reweighted(model, weights), InvalidInput);
    EXPECT_THROW(ShapeModel(model.mean(), model.basis(), model.variance(), {}, weights), InvalidInput);
  }
}

}  // namespace
}  // namespace foramen
