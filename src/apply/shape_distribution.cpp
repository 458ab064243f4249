#include "foramen/apply/shape_distribution.hpp"

#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"
#include "foramen/match/bending_options.hpp"
#include "match/smooth_displacements.hpp"

namespace foramen {
namespace {

constexpr double smallest_share = 1e-6;       // least share of the total variance of a mode that is kept
constexpr Eigen::Index linear_functions = 4;  // the first functions are a constant and three linear ones

}  // namespace

ShapeDistribution distribution_of(const ShapeModel& model) {
  return {model.mean(), model.basis() * model.variance().cwiseSqrt().asDiagonal()};
}

ShapeDistribution with_columns(ShapeDistribution distribution, const Eigen::MatrixXd& columns) {
  FORAMEN_ASSERT(columns.rows() == distribution.mean.size());
  const Eigen::Index before = distribution.factor.cols();
  distribution.factor.conservativeResize(distribution.mean.size(), before + columns.cols());
  distribution.factor.rightCols(columns.cols()) = columns;
  return distribution;
}

Eigen::MatrixXd smooth_columns(const Eigen::VectorXd& mean, double share,
                               const SmoothDisplacementOptions& options) {
  if (!(share > 0))
    throw InvalidInput("smooth_columns: share is " + std::to_string(share) + "; it must be > 0");
  const Eigen::MatrixXd all = smooth_displacements(unflattened(mean), options);
  const Eigen::MatrixXd functions = std::sqrt(share) * all.rightCols(all.cols() - linear_functions);
  Eigen::MatrixXd columns = Eigen::MatrixXd::Zero(mean.size(), 3 * functions.cols());
  for (Eigen::Index i = 0; i < functions.rows(); ++i)
    for (Eigen::Index c = 0; c < 3; ++c)
      columns.row(3 * i + c).segment(c * functions.cols(), functions.cols()) = functions.row(i);
  return columns;
}

std::vector<double> standard_deviations(const ShapeDistribution& distribution) {
  std::vector<double> deviations;
  deviations.reserve(distribution.landmarks());
  for (int i = 0; i < distribution.landmarks(); ++i)
    deviations.push_back(distribution.factor.middleRows<3>(3 * i).norm());
  return deviations;
}

ShapeModel principal_model(const ShapeDistribution& distribution, std::vector<std::array<int, 3>> triangles) {
  const Eigen::MatrixXd& factor = distribution.factor;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(factor.transpose() * factor);
  if (eigen.info() != Eigen::Success)
    throw ConvergenceError("the eigenvalues of the distribution's Gram matrix were not found");
  const Eigen::VectorXd variances = eigen.eigenvalues().reverse();
  const double least = smallest_share * variances.sum();
  Eigen::Index kept = 0;
  while (kept < variances.size() && variances[kept] > least) ++kept;
  Eigen::MatrixXd basis = factor * eigen.eigenvectors().rowwise().reverse().leftCols(kept);
  for (Eigen::Index k = 0; k < kept; ++k) {
    basis.col(k).normalize();
    Eigen::Index largest = 0;
    basis.col(k).cwiseAbs().maxCoeff(&largest);
    if (basis(largest, k) < 0) basis.col(k) *= -1;
  }
  return ShapeModel(distribution.mean, std::move(basis), variances.head(kept), std::move(triangles));
}

}  // namespace foramen
