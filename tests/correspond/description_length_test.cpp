#include "correspond/description_length.hpp"

#include <cmath>

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/correspond/registration_options.hpp"

namespace foramen {
namespace {

using Shapes = std::vector<std::vector<Vec3>>;

Vec3 normal_point(Rng& rng) { return {rng.normal(), rng.normal(), rng.normal()}; }

Shapes random_shapes(int shapes, int points, Rng& rng) {
  Shapes all(shapes);
  for (auto& shape : all)
    for (int k = 0; k < points; ++k) shape.push_back(normal_point(rng));
  return all;
}

std::vector<double> random_weights(int points, Rng& rng) {
  std::vector<double> weights;
  for (int k = 0; k < points; ++k) weights.push_back(rng.uniform(0.5, 2));
  return weights;
}

// The squared distance of two shapes, with weights that sum to 1.
double squared_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b,
                        const std::vector<double>& weights) {
  double sum = 0, total = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    sum += weights[k] * (a[k] - b[k]).squaredNorm();
    total += weights[k];
  }
  return sum / total;
}

TEST(DescriptionLength, OfTwoShapesInClosedForm) {
  // One mode; two shapes 2d apart have variance 2 d^2.
  const Shapes shapes{{Vec3(-3, 0, 0)}, {Vec3(3, 0, 0)}};
  const std::vector<double> one{1.0};
  EXPECT_NEAR(description_length(shapes, one, {.cut_mm2 = 2}).value, 1 + std::log(18.0 / 2), 1e-12);
  EXPECT_NEAR(description_length(shapes, one, {.cut_mm2 = 36}).value, 18.0 / 36, 1e-12);
  // A mode above the cut is shrunk by 1 - cut / variance, one below the cut to the mean.
  EXPECT_NEAR(description_length(shapes, one, {.cut_mm2 = 2}).attractors[1][0].x(), 3 * (1 - 2.0 / 18),
              1e-12);
  EXPECT_NEAR(description_length(shapes, one, {.cut_mm2 = 36}).attractors[1][0].norm(), 0, 1e-12);
}

TEST(DescriptionLength, SlopeIsThatOfDifferences) {
  Rng rng(1);
  Shapes shapes = random_shapes(5, 4, rng);
  const auto weights = random_weights(4, rng);
  const DescriptionLengthOptions options{.cut_mm2 = 0.4};  // some modes are above the cut and some below
  const DescriptionLength at = description_length(shapes, weights, options);
  const double step = 1e-5;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k)
      for (int c = 0; c < 3; ++c) {
        double& x = shapes[i][k][c];
        const double here = x;
        x = here + step;
        const double above = description_length(shapes, weights, options).value;
        x = here - step;
        const double below = description_length(shapes, weights, options).value;
        x = here;
        EXPECT_NEAR(at.slope[i][k][c], (above - below) / (2 * step), 1e-6);
      }
}

TEST(DescriptionLength, DistanceToTheAttractorsBoundsItFromAbove) {
  Rng rng(2);
  const DescriptionLengthOptions options{.cut_mm2 = 0.3};
  for (int trial = 0; trial < 200; ++trial) {
    const Shapes shapes = random_shapes(6, 5, rng);
    const auto weights = random_weights(5, rng);
    const DescriptionLength at = description_length(shapes, weights, options);
    Shapes moved = shapes;
    double change = 0;
    const double size = trial % 2 ? 0.1 : 2.0;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      for (Vec3& p : moved[i]) p += size * normal_point(rng);
      change += squared_distance(moved[i], at.attractors[i], weights) -
                squared_distance(shapes[i], at.attractors[i], weights);
    }
    EXPECT_LE(description_length(moved, weights, options).value,
              at.value + change / (5 * options.cut_mm2) + 1e-9);
  }
}

TEST(DescriptionLength, IsNotChangedByMotionOrOrder) {
  Rng rng(3);
  const Shapes shapes = random_shapes(4, 6, rng);
  const std::vector<double> equal(6, 1.0);
  Shapes other(shapes.rbegin(), shapes.rend());
  const Mat3 turn = Eigen::AngleAxisd(1.3, normal_point(rng).normalized()).toRotationMatrix();
  for (auto& shape : other) {
    for (Vec3& p : shape) p = turn * p + Vec3(1, 2, 3);
    std::swap(shape[1], shape[4]);
  }
  EXPECT_NEAR(description_length(other, equal).value, description_length(shapes, equal).value, 1e-9);
}

TEST(DescriptionLength, RefusesWhatDoesNotFit) {
  const Shapes shapes{{Vec3::Zero()}, {Vec3::Ones()}};
  EXPECT_THROW(description_length({shapes[0]}, std::vector<double>{1}), InvalidInput);
  EXPECT_THROW(description_length(shapes, std::vector<double>{1, 1}), InvalidInput);
  EXPECT_THROW(description_length(shapes, std::vector<double>{0}), InvalidInput);
  EXPECT_THROW(description_length(shapes, std::vector<double>{1}, {.cut_mm2 = 0}), InvalidInput);
}

}  // namespace
}  // namespace foramen
