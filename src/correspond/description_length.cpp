#include "correspond/description_length.hpp"

#include <cmath>
#include <numeric>
#include <string>

#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

void check(const std::vector<std::vector<Vec3>>& aligned, std::span<const double> weights,
           const DescriptionLengthOptions& options) {
  const auto refuse = [](const std::string& what) { throw InvalidInput("description_length: " + what); };
  if (aligned.size() < 2) refuse("at least 2 shapes are needed, found " + std::to_string(aligned.size()));
  for (const auto& shape : aligned)
    if (shape.size() != weights.size())
      refuse("a shape has " + std::to_string(shape.size()) + " points for " + std::to_string(weights.size()) +
             " weights");
  for (const double w : weights)
    if (!(w > 0)) refuse("weights must be > 0");
  check_options("description_length", options);
}

// Deviations from the mean times the square roots of the weights, one column per shape.
Eigen::MatrixXd weighted_deviations(const std::vector<std::vector<Vec3>>& aligned,
                                    const Eigen::VectorXd& roots) {
  const auto points = static_cast<Eigen::Index>(roots.size());
  Eigen::MatrixXd x(3 * points, static_cast<Eigen::Index>(aligned.size()));
  for (Eigen::Index i = 0; i < x.cols(); ++i)
    for (Eigen::Index k = 0; k < points; ++k) x.block<3, 1>(3 * k, i) = roots[k] * aligned[i][k];
  x.colwise() -= x.rowwise().mean().eval();
  return x;
}

}  // namespace

DescriptionLength description_length(const std::vector<std::vector<Vec3>>& aligned,
                                     std::span<const double> weights,
                                     const DescriptionLengthOptions& options) {
  check(aligned, weights, options);
  const auto points = static_cast<Eigen::Index>(weights.size());
  const auto shapes = static_cast<Eigen::Index>(aligned.size());
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  Eigen::VectorXd roots(points);
  for (Eigen::Index k = 0; k < points; ++k) roots[k] = std::sqrt(weights[k] / total);
  const Eigen::MatrixXd x = weighted_deviations(aligned, roots);
  const double divisor = static_cast<double>(shapes - 1), cut = options.cut_mm2;

  // The modes come from the Gram matrix: for x = U S V^T, a function of the covariance times x equals x times
  // the same function of the Gram matrix.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> gram(x.transpose() * x / divisor);
  DescriptionLength result;
  Eigen::VectorXd slopes(shapes);  // dL/dlambda
  for (Eigen::Index m = 0; m < shapes; ++m) {
    const double lambda = std::max(0.0, gram.eigenvalues()[m]);
    result.value += lambda >= cut ? 1 + std::log(lambda / cut) : lambda / cut;
    slopes[m] = lambda >= cut ? 1 / lambda : 1 / cut;
  }
  const Eigen::MatrixXd& v = gram.eigenvectors();
  const Eigen::MatrixXd sloped = x * (v * slopes.asDiagonal() * v.transpose());  // sum_m w_m b_im e_m
  result.slope.resize(aligned.size());
  result.attractors.resize(aligned.size());
  for (Eigen::Index i = 0; i < shapes; ++i)
    for (Eigen::Index k = 0; k < points; ++k) {
      const std::size_t shape = i;
      const Vec3 s = sloped.block<3, 1>(3 * k, i);
      result.slope[shape].push_back(2 / divisor * roots[k] * s);
      result.attractors[shape].push_back(aligned[shape][k] - cut / roots[k] * s);
    }
  return result;
}

}  // namespace foramen
