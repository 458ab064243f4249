#include "correspond/cohort_prior.hpp"

#include <algorithm>
#include <cmath>
#include <string>

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {
namespace {

void check(const Mesh& surface, const Eigen::MatrixXd& functions,
           std::span<const std::vector<Vec3>> corresponding, const CohortPriorOptions& options) {
  const auto refuse = [](const std::string& what) { throw InvalidInput("cohort_priors: " + what); };
  if (functions.rows() != surface.vertex_count()) refuse("needs a row of functions per vertex");
  for (const auto& points : corresponding)
    if (static_cast<int>(points.size()) != surface.vertex_count())
      refuse("a shape has " + std::to_string(points.size()) + " points for " +
             std::to_string(surface.vertex_count()) + " vertices");
  check_options("cohort_priors", options);
}

// The coefficients of the displacements of all shapes by ridge regression, one column of 3 R per shape.
Eigen::MatrixXd coefficients_of(const Mesh& surface, const Eigen::MatrixXd& functions,
                                std::span<const std::vector<Vec3>> corresponding,
                                const CohortPriorOptions& options) {
  const Eigen::Index rank = functions.cols();
  const std::vector<double> areas = vertex_areas(surface).values();
  const Eigen::VectorXd weights = Eigen::Map<const Eigen::VectorXd>(areas.data(), functions.rows()) /
                                  (options.independent_area_mm2 * options.noise_mm * options.noise_mm);
  const Eigen::MatrixXd weighted = weights.asDiagonal() * functions;
  Eigen::MatrixXd normal = functions.transpose() * weighted;
  normal.diagonal().array() += 1;
  const Eigen::LLT<Eigen::MatrixXd> factor(normal);

  Eigen::MatrixXd coefficients(3 * rank, static_cast<Eigen::Index>(corresponding.size()));
  for (Eigen::Index i = 0; i < coefficients.cols(); ++i) {
    Eigen::MatrixX3d displacement(functions.rows(), 3);
    for (VertexId v : surface.vertices())
      displacement.row(v.index) = (corresponding[i][v.index] - surface.position(v)).transpose();
    const Eigen::MatrixX3d solved = factor.solve(weighted.transpose() * displacement);
    coefficients.col(i) = solved.reshaped();
  }
  return coefficients;
}

// The normal distribution with the mean and the covariance of the columns.
DisplacementPrior distribution_of(Eigen::MatrixXd columns) {
  DisplacementPrior prior;
  prior.mean = columns.rowwise().mean();
  columns.colwise() -= prior.mean;
  prior.directions = columns / std::sqrt(static_cast<double>(columns.cols() - 1));
  return prior;
}

Eigen::MatrixXd without_column(const Eigen::MatrixXd& all, Eigen::Index left_out) {
  Eigen::MatrixXd others(all.rows(), all.cols() - 1);
  others << all.leftCols(left_out), all.rightCols(all.cols() - left_out - 1);
  return others;
}

}  // namespace

DisplacementPrior CohortPriors::of_member(int shape) const {
  if (coefficients.size() == 0) return {};
  DisplacementPrior prior = distribution_of(without_column(coefficients, shape));
  prior.variance = unexplained_share;
  return prior;
}

DisplacementPrior CohortPriors::of_newcomer() const {
  if (coefficients.size() == 0) return {};
  DisplacementPrior prior = distribution_of(coefficients);
  prior.variance = unexplained_share;
  return prior;
}

CohortPriors cohort_priors(const Mesh& surface, const Eigen::MatrixXd& functions,
                           std::span<const std::vector<Vec3>> corresponding,
                           const CohortPriorOptions& options) {
  check(surface, functions, corresponding, options);
  CohortPriors priors;
  if (corresponding.size() < 3) return priors;
  priors.coefficients = coefficients_of(surface, functions, corresponding, options);
  const Eigen::MatrixXd& all = priors.coefficients;

  double unexplained = 0, total = 0;
  for (Eigen::Index i = 0; i < all.cols(); ++i) {
    const DisplacementPrior prior = distribution_of(without_column(all, i));
    const Eigen::VectorXd own = all.col(i) - prior.mean;
    const Eigen::VectorXd explained = prior.directions * prior.directions.colPivHouseholderQr().solve(own);
    unexplained += (own - explained).squaredNorm();
    total += own.squaredNorm();
  }
  if (total > 0) priors.unexplained_share = std::clamp(unexplained / total, options.least_share, 1.0);
  return priors;
}

}  // namespace foramen
