#include "match/smooth_displacements.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

void check(std::span<const Vec3> points, const SmoothDisplacementOptions& options) {
  const auto refuse = [](const std::string& what) { throw InvalidInput("smooth_displacements: " + what); };
  if (points.empty()) refuse("there are no points");
  if (options.scales.empty()) refuse("no scale is given");
  check_options("smooth_displacements", options);
}

double covariance(const std::vector<DisplacementScale>& scales, double squared_distance) {
  double sum = 0;
  for (const DisplacementScale& s : scales)
    sum += s.amplitude_mm * s.amplitude_mm * std::exp(-squared_distance / (2 * s.length_mm * s.length_mm));
  return sum;
}

// K ~ L L^T. The next pivot is always the point with the largest variance that is not yet explained.
Eigen::MatrixXd pivoted_cholesky(std::span<const Vec3> points, const SmoothDisplacementOptions& options) {
  const auto count = static_cast<Eigen::Index>(points.size());
  const Eigen::Index most = std::min<Eigen::Index>(count, options.most_functions);
  Eigen::MatrixXd factor(count, most);
  Eigen::VectorXd left = Eigen::VectorXd::Constant(count, covariance(options.scales, 0));
  for (Eigen::Index k = 0; k < most; ++k) {
    Eigen::Index pivot = 0;
    const double worst = left.maxCoeff(&pivot);
    if (worst <= options.left_out_mm * options.left_out_mm) return factor.leftCols(k);
    Eigen::VectorXd column(count);
    for (Eigen::Index i = 0; i < count; ++i)
      column[i] = covariance(options.scales, (points[i] - points[pivot]).squaredNorm());
    column.noalias() -= factor.leftCols(k) * factor.row(pivot).head(k).transpose();
    factor.col(k) = column / std::sqrt(worst);
    left = (left - factor.col(k).cwiseAbs2()).cwiseMax(0);
  }
  return factor;
}

// The same process in a basis ordered by decreasing norm. The sign of a function makes its largest value
// positive.
Eigen::MatrixXd strongest_first(const Eigen::MatrixXd& factor) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(factor.transpose() * factor);
  Eigen::MatrixXd functions = factor * gram.eigenvectors().rowwise().reverse();
  for (Eigen::Index k = 0; k < functions.cols(); ++k) {
    Eigen::Index at = 0;
    functions.col(k).cwiseAbs().maxCoeff(&at);
    if (functions(at, k) < 0) functions.col(k) *= -1;
  }
  return functions;
}

}  // namespace

Eigen::MatrixXd smooth_displacements(std::span<const Vec3> points, const SmoothDisplacementOptions& options) {
  check(points, options);
  const auto count = static_cast<Eigen::Index>(points.size());
  Vec3 centre = Vec3::Zero();
  for (const Vec3& p : points) centre += p;
  centre /= static_cast<double>(count);
  double squared_radius = 0;
  for (const Vec3& p : points) squared_radius += (p - centre).squaredNorm() / static_cast<double>(count);

  const Eigen::MatrixXd smooth = strongest_first(pivoted_cholesky(points, options));
  Eigen::MatrixXd functions(count, 4 + smooth.cols());
  functions.col(0).setConstant(options.shift_mm);
  for (Eigen::Index i = 0; i < count; ++i)
    functions.row(i).segment<3>(1) =
        options.linear_mm / std::sqrt(squared_radius) * (points[i] - centre).transpose();
  functions.rightCols(smooth.cols()) = smooth;
  return functions;
}

}  // namespace foramen
