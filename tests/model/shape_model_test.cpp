#include "foramen/model/shape_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "foramen/core/error.hpp"
#include "foramen/model/procrustes.hpp"

namespace foramen {
namespace {

using Shapes = std::vector<std::vector<Vec3>>;

/// Orthonormal columns by Gram-Schmidt on random numbers.
Eigen::MatrixXd random_basis(int rows, int columns, std::uint64_t seed) {
  Rng rng(seed);
  Eigen::MatrixXd basis(rows, columns);
  for (Eigen::Index k = 0; k < columns; ++k) {
    for (Eigen::Index i = 0; i < rows; ++i) basis(i, k) = rng.normal();
    for (int pass = 0; pass < 2; ++pass)
      for (Eigen::Index j = 0; j < k; ++j) basis.col(k) -= basis.col(j).dot(basis.col(k)) * basis.col(j);
    basis.col(k).normalize();
  }
  return basis;
}

Shapes random_shapes(int count, int landmarks, std::uint64_t seed) {
  Rng rng(seed);
  Shapes shapes(count);
  for (auto& shape : shapes)
    for (int i = 0; i < landmarks; ++i)
      shape.emplace_back(20 + i + rng.normal(), -3.0 * i + rng.normal(), 2 * rng.normal());
  return shapes;
}

double total_variance(const Shapes& shapes) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(flattened(shapes[0]).size());
  for (const auto& s : shapes) mean += flattened(s) / static_cast<double>(shapes.size());
  double sum = 0;
  for (const auto& s : shapes) sum += (flattened(s) - mean).squaredNorm();
  return sum / static_cast<double>(shapes.size() - 1);
}

TEST(ShapeModel, TwoShapesGiveTheClosedForm) {
  // x = +-a about the middle: one mode along a, variance 2 a^2 / (2 - 1).
  const std::vector<Vec3> first{{1, 0, 0}, {0, 5, 0}}, second{{3, 0, 0}, {0, 5, 4}};
  const ShapeModel model = model_of_aligned({first, second}, {});
  ASSERT_EQ(model.modes(), 1);
  EXPECT_NEAR(model.variance()[0], 2 * (1 + 4), 1e-13);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(6);
  direction[0] = 1 / std::sqrt(5);
  direction[5] = 2 / std::sqrt(5);
  EXPECT_LT((model.basis().col(0) - direction).norm(), 1e-14);
  EXPECT_LT((model.mean() - flattened(std::vector<Vec3>{{2, 0, 0}, {0, 5, 2}})).norm(), 1e-15);
}

TEST(ShapeModel, RecoversPlantedModesAndVariances) {
  // Scores of mode k are +-s_k on two shapes each, zero elsewhere: variance 2 s_k^2 / (2K - 1).
  const int modes = 5, rows = 3 * 50;
  const Eigen::MatrixXd basis = random_basis(rows, modes, 3);
  const Eigen::VectorXd mean = 30 * random_basis(rows, 1, 4);
  Shapes shapes;
  for (int k = 0; k < modes; ++k)
    for (const double side : {1.0, -1.0})
      shapes.push_back(unflattened(mean + side * (10.0 / (k + 1)) * basis.col(k)));
  const ShapeModel model = model_of_aligned(shapes, {});
  ASSERT_EQ(model.modes(), modes);
  EXPECT_LT((model.mean() - mean).norm(), 1e-13);
  for (int k = 0; k < modes; ++k) {
    EXPECT_NEAR(model.variance()[k], 2 * 100.0 / ((k + 1) * (k + 1)) / (2 * modes - 1), 1e-12);
    EXPECT_NEAR(std::abs(model.basis().col(k).dot(basis.col(k))), 1.0, 1e-13);
  }
}

TEST(ShapeModel, AgreesWithTheFullCovariance) {
  const Shapes shapes = random_shapes(6, 8, 5);
  const ShapeModel model = model_of_aligned(shapes, {});
  Eigen::MatrixXd x(24, 6);
  for (Eigen::Index s = 0; s < 6; ++s) x.col(s) = flattened(shapes[s]);
  x.colwise() -= Eigen::VectorXd(x.rowwise().mean());
  const Eigen::MatrixXd covariance = x * x.transpose() / 5;
  const Eigen::MatrixXd modelled = model.basis() * model.variance().asDiagonal() * model.basis().transpose();
  EXPECT_LT((covariance - modelled).norm(), 1e-12 * covariance.norm());
}

TEST(ShapeModel, ModesAreOrthonormalOrderedAndSigned) {
  Shapes shapes = random_shapes(12, 100, 6);
  for (std::size_t s = 0; s < shapes.size();
       ++s)  // variances over 8 decades, for which the Gram matrix alone loses orthogonality
    for (std::size_t i = 0; i < 100; ++i)
      shapes[s][i] =
          shapes[0][i] + std::pow(10.0, -0.35 * static_cast<double>(s)) * (shapes[s][i] - shapes[0][i]);
  const ShapeModel model = model_of_aligned(shapes, {});
  const auto k = model.modes();
  EXPECT_GE(k, 9);
  EXPECT_LT(
      (model.basis().transpose() * model.basis() - Eigen::MatrixXd::Identity(k, k)).cwiseAbs().maxCoeff(),
      1e-12);
  for (int m = 0; m < k; ++m) {
    Eigen::Index largest = 0;
    model.basis().col(m).cwiseAbs().maxCoeff(&largest);
    EXPECT_GT(model.basis()(largest, m), 0);
    if (m > 0) {
      EXPECT_LE(model.variance()[m], model.variance()[m - 1]);
      EXPECT_GT(model.variance()[m], 1e-10 * model.variance()[0]);
    }
  }
}

TEST(ShapeModel, VariancesSumToTheTotal) {
  for (const int count : {2, 3, 9, 20}) {
    const Shapes shapes = random_shapes(count, 30, 7);
    const ShapeModel model = model_of_aligned(shapes, {});
    EXPECT_EQ(model.modes(), count - 1);
    EXPECT_NEAR(model.variance().sum(), total_variance(shapes), 1e-11 * total_variance(shapes));
  }
}

TEST(ShapeModel, VarianceOfTheScoresIsTheVariance) {
  const Shapes shapes = random_shapes(9, 30, 8);
  const ShapeModel model = model_of_aligned(shapes, {});
  Eigen::VectorXd squares = Eigen::VectorXd::Zero(model.modes());
  for (const auto& s : shapes) squares += model.scores(flattened(s), model.modes()).cwiseAbs2();
  EXPECT_LT((squares / 8 - model.variance()).norm(), 1e-11 * model.variance().norm());
}

TEST(ShapeModel, FewerIndependentShapesGiveFewerModes) {
  const Shapes three = random_shapes(3, 20, 9);
  const Shapes repeated{three[0], three[1], three[2], three[0], three[1], three[2]};
  EXPECT_EQ(model_of_aligned(repeated, {}).modes(), 2);
}

TEST(ShapeModel, IdenticalShapesHaveNoModes) {
  const auto shape = random_shapes(1, 200, 10)[0];
  EXPECT_EQ(model_of_aligned({shape, shape, shape}, {}).modes(), 0);
  Shapes turned;  // shapes that differ only in pose; rounding errors of the alignment must not become a mode
  for (int s = 0; s < 4; ++s) {
    const Eigen::AngleAxisd turn(0.7 * s, Vec3(1, 2, 3).normalized());
    turned.emplace_back();
    for (const Vec3& p : shape) turned.back().push_back(turn * p + 100.0 * s * Vec3::Ones());
  }
  const ShapeModel model = model_of_aligned(procrustes(turned, ScaleMode::keep).aligned, {});
  EXPECT_EQ(model.modes(), 0);
  EXPECT_EQ(model.reconstruct(Eigen::VectorXd(0)), model.mean());
}

TEST(ShapeModel, ScoresAndReconstructionAreInverse) {
  const Shapes shapes = random_shapes(8, 25, 11);
  const ShapeModel model = model_of_aligned(shapes, {});
  for (const auto& s : shapes)  // all modes span every training shape
    EXPECT_LT((model.reconstruct(model.scores(flattened(s), model.modes())) - flattened(s)).norm(), 1e-11);
  const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(4, -3, 5);
  EXPECT_LT((model.scores(model.reconstruct(b), 4) - b).norm(), 1e-11);
  double before = std::numeric_limits<double>::infinity();
  for (int m = 0; m <= model.modes(); ++m) {  // more modes never fit worse
    const double error =
        (model.reconstruct(model.scores(flattened(shapes[3]), m)) - flattened(shapes[3])).norm();
    EXPECT_LE(error, before + 1e-12);
    before = error;
  }
}

TEST(ShapeModel, RotatingAllShapesRotatesTheModel) {
  Shapes shapes = random_shapes(6, 15, 12);
  const ShapeModel before = model_of_aligned(shapes, {});
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(3, -1, 2).normalized()).toRotationMatrix();
  for (auto& s : shapes)
    for (Vec3& p : s) p = turn * p;
  const ShapeModel after = model_of_aligned(shapes, {});
  ASSERT_EQ(before.modes(), after.modes());
  EXPECT_LT((before.variance() - after.variance()).norm(), 1e-11 * before.variance().norm());
}

TEST(ShapeModel, DrawsHaveTheModelsVariance) {
  const ShapeModel model = model_of_aligned(random_shapes(5, 10, 13), {});
  const Rng root(1);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(model.modes()), squares = sum;
  const int draws = 20000;
  for (int i = 0; i < draws; ++i) {
    Rng rng = root.fork(static_cast<std::uint64_t>(i));
    const Eigen::VectorXd b = model.draw(rng);
    sum += b;
    squares += b.cwiseAbs2();
  }
  for (int m = 0; m < model.modes(); ++m) {  // tolerance of five standard errors
    EXPECT_NEAR(sum[m] / draws, 0, 5 * std::sqrt(model.variance()[m] / draws));
    EXPECT_NEAR(squares[m] / draws / model.variance()[m], 1, 5 * std::sqrt(2.0 / draws));
  }
}

TEST(ShapeModel, AlongModeIsInStandardDeviations) {
  const ShapeModel model = model_of_aligned(random_shapes(5, 10, 14), {});
  const Eigen::VectorXd step = model.along_mode(1, -2) - model.mean();
  EXPECT_NEAR(step.norm(), 2 * std::sqrt(model.variance()[1]), 1e-12);
  EXPECT_NEAR(model.basis().col(1).dot(step), -2 * std::sqrt(model.variance()[1]), 1e-12);
}

TEST(ShapeModel, RefusesWhatItCannotUse) {
  const Shapes shapes = random_shapes(4, 10, 15);
  EXPECT_THROW(model_of_aligned({shapes[0]}, {}), InvalidInput);
  EXPECT_THROW(model_of_aligned({}, {}), InvalidInput);
  auto missing = shapes;
  missing[1].pop_back();
  EXPECT_THROW(model_of_aligned(missing, {}), InvalidInput);
  auto broken = shapes;
  broken[1][2].x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(model_of_aligned(broken, {}), InvalidInput);
  EXPECT_THROW(model_of_aligned(shapes, {{0, 1, 10}}), InvalidInput);
  const ShapeModel model = model_of_aligned(shapes, {{0, 1, 9}});
  EXPECT_THROW(model.scores(Eigen::VectorXd::Zero(27), 1), InvalidInput);
  EXPECT_THROW(model.scores(model.mean(), 4), InvalidInput);
  EXPECT_THROW(model.reconstruct(Eigen::VectorXd::Zero(4)), InvalidInput);
  EXPECT_THROW(model.along_mode(3, 1), InvalidInput);
  EXPECT_THROW(ShapeModel(model.mean(), model.basis(), Eigen::VectorXd::Zero(2), {}), InvalidInput);
  EXPECT_THROW(ShapeModel(model.mean(), model.basis(), Eigen::VectorXd::Constant(3, -1), {}), InvalidInput);
  EXPECT_THROW(ShapeModel(Eigen::VectorXd::Zero(7), Eigen::MatrixXd(7, 0), Eigen::VectorXd(0), {}),
               InvalidInput);
}

}  // namespace
}  // namespace foramen
