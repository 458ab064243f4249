#include "synth/random_flow.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

namespace foramen {
namespace {

constexpr double correlation_mm = 20;

std::vector<VelocityField> some_fields(int count, std::uint64_t seed = 1) {
  Rng rng(seed);
  return random_velocity_fields(count, {.correlation_mm = correlation_mm}, rng);
}

// The mean of v_k(x) v_l(x + r) over many fields.
Mat3 covariance(const Vec3& x, const Vec3& r, int groups) {
  Mat3 sum = Mat3::Zero();
  int count = 0;
  for (int g = 0; g < groups; ++g)
    for (const VelocityField& v : some_fields(10, static_cast<std::uint64_t>(100 + g))) {
      sum += v(x) * v(x + r).transpose();
      ++count;
    }
  return sum / count;
}

TEST(RandomFlow, FieldsHaveUnitVarianceAndTheStatedCorrelation) {
  const Vec3 x(30, -20, 10);
  // 4000 fields: the standard error of a variance is 0.022
  for (double r : {0.0, correlation_mm, 3 * correlation_mm}) {
    const Mat3 c = covariance(x, Vec3(0.6, 0, 0.8) * r, 400);
    const double expected = std::exp(-r * r / (2 * correlation_mm * correlation_mm));
    EXPECT_LT((c - expected * Mat3::Identity()).cwiseAbs().maxCoeff(), 0.1) << "r = " << r;
  }
}

TEST(RandomFlow, SymmetricFieldsHaveTheStatedCorrelationOfLeftAndRight) {
  constexpr double correlation = 0.6;
  const Vec3 left(30, -20, 10), right(-30, -20, 10), mirror(-1, 1, 1);
  double variance = 0, product = 0;
  constexpr int fields = 2000;  // the standard error of a mean of products is at most 0.02
  for (int k = 0; k < fields; ++k) {
    Rng rng(static_cast<std::uint64_t>(k));
    const VelocityField v =
        symmetric_velocity_field(correlation, {.correlation_mm = correlation_mm, .features = 32}, rng);
    variance += v(left).squaredNorm() / 3 / fields;
    product += v(left).dot(mirror.cwiseProduct(v(right))) / 3 / fields;
  }
  EXPECT_NEAR(variance, 1, 0.1);
  EXPECT_NEAR(product, correlation, 0.1);
}

TEST(RandomFlow, AFullySymmetricFieldIsItsMirrorImage) {
  Rng rng(4);
  const VelocityField v = symmetric_velocity_field(1, {.correlation_mm = correlation_mm}, rng);
  const Vec3 mirror(-1, 1, 1), p(12, 5, -30);
  EXPECT_NEAR((mirror.cwiseProduct(v(mirror.cwiseProduct(p))) - v(p)).norm(), 0, 1e-12);
}

TEST(RandomFlow, AUniformFieldMovesByItself) {
  const VelocityField still{{Vec3::Zero()}, {Vec3(1, -2, 3)}, {Vec3(7, 7, 7)}};
  const std::vector<Vec3> points{Vec3(1, 1, 1), Vec3(-5, 0, 2)};
  const auto moved = carried_by_flow(points, still, 4);
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_NEAR((moved[i] - points[i] - Vec3(1, -2, 3)).norm(), 0, 1e-13);
}

TEST(RandomFlow, TheInverseFieldLeadsBack) {
  const auto fields = some_fields(1);
  const VelocityField there = weighted_sum(fields, std::vector<double>{4.0}),
                      back = weighted_sum(fields, std::vector<double>{-4.0});
  std::vector<Vec3> points;
  Rng rng(9);
  for (int i = 0; i < 200; ++i) points.emplace_back(Vec3(rng.normal(), rng.normal(), rng.normal()) * 30);
  const auto returned = carried_by_flow(carried_by_flow(points, there, 16), back, 16);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT((returned[i] - points[i]).norm(), 1e-4);
}

TEST(RandomFlow, StepsConvergeWithFourthOrder) {
  const auto fields = some_fields(1);
  const VelocityField field = weighted_sum(fields, std::vector<double>{10.0});
  std::vector<Vec3> points;
  for (int i = -5; i <= 5; ++i) points.emplace_back(7.0 * i, 3.0 * i, -2.0 * i);
  const auto exact = carried_by_flow(points, field, 256);
  const auto error = [&](int steps) {
    double sum = 0;
    const auto moved = carried_by_flow(points, field, steps);
    for (std::size_t i = 0; i < points.size(); ++i) sum += (moved[i] - exact[i]).norm();
    return sum;
  };
  EXPECT_GT(error(4) / error(8), 10);
  EXPECT_LT(error(8) / error(4), 0.1);
  EXPECT_LT(error(8) / static_cast<double>(points.size()), 1e-2);
}

TEST(RandomFlow, TheJacobianStaysPositive) {
  const auto fields = some_fields(1, 5);
  const VelocityField field = weighted_sum(fields, std::vector<double>{6.0});
  constexpr double h = 1e-4;
  Rng rng(2);
  for (int i = 0; i < 200; ++i) {
    const Vec3 p = Vec3(rng.normal(), rng.normal(), rng.normal()) * 30;
    const auto q = carried_by_flow(
        std::vector<Vec3>{p, p + h * Vec3::UnitX(), p + h * Vec3::UnitY(), p + h * Vec3::UnitZ()}, field, 16);
    Mat3 jacobian;
    for (int k = 0; k < 3; ++k) jacobian.col(k) = (q[k + 1] - q[0]) / h;
    EXPECT_GT(jacobian.determinant(), 0);
  }
}

TEST(RandomFlow, WeightedSumsAreLinear) {
  const auto fields = some_fields(3);
  const std::vector<double> weights{0.5, -2, 1.5};
  const VelocityField sum = weighted_sum(fields, weights);
  const Vec3 p(3, 40, -12);
  EXPECT_NEAR((sum(p) - (0.5 * fields[0](p) - 2 * fields[1](p) + 1.5 * fields[2](p))).norm(), 0, 1e-12);
}

}  // namespace
}  // namespace foramen
