#include "match/rigid_step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Cholesky>

#include "match/robust_weight.hpp"

namespace foramen::detail {
namespace {

using Vec6 = Eigen::Matrix<double, 6, 1>;
using Mat6 = Eigen::Matrix<double, 6, 6>;

// Standard deviation / median of |x| for a normal distribution.
constexpr double median_to_deviation = 1.4826;
constexpr double tukey_cutoff = 4.685;  // standard deviations: 95 % efficiency for data without outliers

double sq(double x) { return x * x; }

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Vec3 middle(const Match& m) { return 0.5 * (m.moving + m.fixed); }

Vec3 weighted_centroid(std::span<const Match> matches, std::span<const double> weights, double total) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < matches.size(); ++i) sum += weights[i] * middle(matches[i]);
  return sum / total;
}

}  // namespace

std::vector<double> tukey_weights(std::span<const Match> matches, double least_scale) {
  if (matches.empty()) return {};
  std::vector<double> distances;
  distances.reserve(matches.size());
  for (const Match& m : matches) distances.push_back(m.distance);
  const double deviation = median_to_deviation * upper_median(std::move(distances));
  const double reach = tukey_cutoff * std::max(least_scale, deviation);
  std::vector<double> weights;
  weights.reserve(matches.size());
  for (const Match& m : matches) weights.push_back(tukey_weight(sq(m.distance / reach)));
  return weights;
}

RigidTransform rigid_step(std::span<const Match> matches, std::span<const double> weights,
                          const RigidStepOptions& options) {
  double total = 0;
  for (double w : weights) total += w;
  if (!(total > 0)) return RigidTransform::Identity();
  const Vec3 centre = weighted_centroid(matches, weights, total);
  Mat6 normal_matrix = Mat6::Zero();
  Vec6 right_side = Vec6::Zero();
  for (std::size_t i = 0; i < matches.size(); ++i) {
    const Match& m = matches[i];
    // The residual is d + omega x (middle - centre) + t, measured in the metric of the match.
    const Mat3 metric = weights[i] * ((1 - options.point_share) * m.normal * m.normal.transpose() +
                                      options.point_share * Mat3::Identity());
    const Mat3 arm = cross_matrix(middle(m) - centre);  // omega x a = -arm omega
    const Mat3 arm_metric = arm * metric;
    const Vec3 pull = metric * (m.fixed - m.moving);
    normal_matrix.topLeftCorner<3, 3>() -= arm_metric * arm;
    normal_matrix.topRightCorner<3, 3>() += arm_metric;
    normal_matrix.bottomRightCorner<3, 3>() += metric;
    right_side.head<3>() += arm * pull;
    right_side.tail<3>() += pull;
  }
  normal_matrix.bottomLeftCorner<3, 3>() = normal_matrix.topRightCorner<3, 3>().transpose();
  const Vec6 step = options.length * normal_matrix.ldlt().solve(right_side);
  if (!step.allFinite()) return RigidTransform::Identity();
  const double angle = step.head<3>().norm();
  RigidTransform motion = RigidTransform::Identity();
  if (angle > 0) motion.linear() = Eigen::AngleAxisd(angle, step.head<3>() / angle).toRotationMatrix();
  motion.translation() = centre + step.tail<3>() - motion.linear() * centre;
  return motion;
}

}  // namespace foramen::detail
