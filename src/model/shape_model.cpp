#include "foramen/model/shape_model.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

constexpr double smallest_variance_ratio = 1e-10;  // relative to the variance of the first mode
constexpr double rounding_of_shapes =
    1e-12;  // relative to the size of a shape: smaller differences are rounding

/// One column per shape: its difference from the mean.
Eigen::MatrixXd centred_columns(const std::vector<std::vector<Vec3>>& aligned, const Eigen::VectorXd& mean) {
  Eigen::MatrixXd x(mean.size(), static_cast<Eigen::Index>(aligned.size()));
  for (std::size_t s = 0; s < aligned.size(); ++s)
    x.col(static_cast<Eigen::Index>(s)) = flattened(aligned[s]) - mean;
  return x;
}

Eigen::VectorXd mean_of(const std::vector<std::vector<Vec3>>& aligned) {
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(3 * aligned[0].size()));
  for (const auto& shape : aligned) mean += flattened(shape);
  return mean / static_cast<double>(aligned.size());
}

/// Multiplies rows by the square roots of the landmark weights. In these coordinates the weighted inner
/// product is the Euclidean one.
void scale_rows(Eigen::Ref<Eigen::MatrixXd> x, const std::vector<double>& weights) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    x.middleRows<3>(static_cast<Eigen::Index>(3 * i)) *= std::sqrt(weights[i]);
}

/// The inverse of scale_rows().
void unscale_rows(Eigen::Ref<Eigen::MatrixXd> x, const std::vector<double>& weights) {
  for (std::size_t i = 0; i < weights.size(); ++i)
    x.middleRows<3>(static_cast<Eigen::Index>(3 * i)) /= std::sqrt(weights[i]);
}

/// Makes column k orthonormal to the columns before it by Gram-Schmidt; the second pass removes the rounding
/// of the first. False if the column depends linearly on them.
bool orthonormalise(Eigen::MatrixXd& basis, Eigen::Index k) {
  for (int pass = 0; pass < 2; ++pass) {
    for (Eigen::Index j = 0; j < k; ++j) basis.col(k) -= basis.col(j).dot(basis.col(k)) * basis.col(j);
    const double length = basis.col(k).norm();
    if (!(length > 0)) return false;
    basis.col(k) /= length;
  }
  return true;
}

/// Makes the largest component of each mode positive; of components of equal size the first one counts.
void fix_signs(Eigen::MatrixXd& basis) {
  for (Eigen::Index k = 0; k < basis.cols(); ++k) {
    Eigen::Index largest = 0;
    basis.col(k).cwiseAbs().maxCoeff(&largest);
    if (basis(largest, k) < 0) basis.col(k) *= -1.0;
  }
}

struct Modes {
  Eigen::MatrixXd basis;
  Eigen::VectorXd variance;
};

/// Variances below either of these bounds are no modes.
struct SmallestVariance {
  double absolute = 0;           // mm^2
  double relative_to_first = 0;  // relative to the variance of the first mode
};

/// At most `most` modes of x x^T / divisor; the rows of x are scaled by scale_rows().
Modes principal_modes(const Eigen::MatrixXd& x, double divisor, Eigen::Index most,
                      SmallestVariance smallest) {
  // The eigenvectors of the n x n matrix X^T X give those of the much larger 3P x 3P matrix X X^T.
  const Eigen::MatrixXd gram = x.transpose() * x / divisor;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  if (eigen.info() != Eigen::Success)
    throw ConvergenceError("the eigenvalues of the shapes' Gram matrix were not found");
  Eigen::MatrixXd basis(x.rows(), most);
  Eigen::VectorXd variance(most);
  Eigen::Index kept = 0;
  for (Eigen::Index k = 0; k < most; ++k) {
    const Eigen::Index column = x.cols() - 1 - k;  // Eigen sorts eigenvalues in increasing order
    basis.col(kept) = x * eigen.eigenvectors().col(column);
    if (!orthonormalise(basis, kept)) continue;
    variance[kept] = (basis.col(kept).transpose() * x).squaredNorm() / divisor;
    const double least = kept == 0 ? 0.0 : smallest.relative_to_first * variance[0];
    if (!(variance[kept] > std::max(least, smallest.absolute))) break;
    ++kept;
  }
  return {basis.leftCols(kept), variance.head(kept)};
}

void check_weights(const std::vector<double>& weights, int landmarks) {
  if (weights.empty()) return;
  if (std::ssize(weights) != landmarks)
    throw InvalidInput("found " + std::to_string(weights.size()) + " weights for a shape model of " +
                       std::to_string(landmarks) + " landmarks: give one per landmark, or none");
  for (const double w : weights)
    if (!(w > 0) || !std::isfinite(w))
      throw InvalidInput("found the landmark weight " + std::to_string(w) +
                         " for a shape model: weights must be finite and > 0");
}

void check_shapes(const std::vector<std::vector<Vec3>>& aligned) {
  if (aligned.size() < 2)
    throw InvalidInput("a shape model needs at least 2 shapes, found " + std::to_string(aligned.size()));
  for (std::size_t s = 0; s < aligned.size(); ++s) {
    if (aligned[s].empty() || aligned[s].size() != aligned[0].size())
      throw InvalidInput("shape " + std::to_string(s) + " has " + std::to_string(aligned[s].size()) +
                         " landmarks, shape 0 has " + std::to_string(aligned[0].size()) +
                         ": corresponding shapes must have the same number, and at least one");
    for (const Vec3& p : aligned[s])
      if (!p.allFinite())
        throw InvalidInput("shape " + std::to_string(s) + " has a coordinate that is not finite");
  }
}

}  // namespace

ShapeModel::ShapeModel(Eigen::VectorXd mean, Eigen::MatrixXd basis, Eigen::VectorXd variance,
                       std::vector<std::array<int, 3>> triangles, std::vector<double> weights)
    : mean_(std::move(mean)),
      basis_(std::move(basis)),
      variance_(std::move(variance)),
      triangles_(std::move(triangles)),
      weights_(std::move(weights)) {
  if (mean_.size() == 0 || mean_.size() % 3 != 0)
    throw InvalidInput("the mean of a shape model has " + std::to_string(mean_.size()) +
                       " numbers: three per landmark are needed");
  if (basis_.cols() != variance_.size() || (basis_.cols() > 0 && basis_.rows() != mean_.size()))
    throw InvalidInput("the basis is " + std::to_string(basis_.rows()) + " x " +
                       std::to_string(basis_.cols()) + " for " + std::to_string(mean_.size()) +
                       " coordinates and " + std::to_string(variance_.size()) + " variances");
  if (basis_.cols() == 0) basis_.resize(mean_.size(), 0);
  if (!mean_.allFinite() || !basis_.allFinite() || !variance_.allFinite() || (variance_.array() < 0).any())
    throw InvalidInput("a shape model holds a number that is not finite, or a negative variance");
  for (std::size_t t = 0; t < triangles_.size(); ++t)
    for (const int corner : triangles_[t])
      if (corner < 0 || corner >= landmarks())
        throw InvalidInput("triangle " + std::to_string(t) + " of the shape model names landmark " +
                           std::to_string(corner) + " of " + std::to_string(landmarks()));
  check_weights(weights_, landmarks());
}

double ShapeModel::total_weight() const {
  return weights_.empty() ? landmarks() : std::accumulate(weights_.begin(), weights_.end(), 0.0);
}

Eigen::VectorXd ShapeModel::reconstruct(const Eigen::VectorXd& b) const {
  if (b.size() > variance_.size())
    throw InvalidInput("found " + std::to_string(b.size()) + " scores for a model of " +
                       std::to_string(modes()) + " modes");
  return mean_ + basis_.leftCols(b.size()) * b;
}

Eigen::VectorXd ShapeModel::scores(const Eigen::VectorXd& shape, int modes_asked) const {
  if (shape.size() != mean_.size())
    throw InvalidInput("the shape has " + std::to_string(shape.size() / 3) + " landmarks, the model " +
                       std::to_string(landmarks()));
  if (modes_asked < 0 || modes_asked > modes())
    throw InvalidInput("asked for " + std::to_string(modes_asked) + " scores of a model of " +
                       std::to_string(modes()) + " modes");
  Eigen::VectorXd difference = shape - mean_;
  for (std::size_t i = 0; i < weights_.size(); ++i)
    difference.segment<3>(static_cast<Eigen::Index>(3 * i)) *= weights_[i];
  return basis_.leftCols(modes_asked).transpose() * difference;
}

Eigen::VectorXd ShapeModel::draw(Rng& rng) const {
  Eigen::VectorXd b(variance_.size());
  for (Eigen::Index m = 0; m < b.size(); ++m) b[m] = std::sqrt(variance_[m]) * rng.normal();
  return b;
}

Eigen::VectorXd ShapeModel::along_mode(int mode, double sd) const {
  if (mode < 0 || mode >= modes())
    throw InvalidInput("asked for mode " + std::to_string(mode) + " (from 0) of a model of " +
                       std::to_string(modes()) + " modes");
  return mean_ + sd * std::sqrt(variance_[mode]) * basis_.col(mode);
}

double ShapeModel::landmark_rms(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const {
  FORAMEN_ASSERT(a.size() == mean_.size() && b.size() == mean_.size());
  double squares = weights_.empty() ? (a - b).squaredNorm() : 0;
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const auto at = static_cast<Eigen::Index>(3 * i);
    squares += weights_[i] * (a.segment<3>(at) - b.segment<3>(at)).squaredNorm();
  }
  return std::sqrt(squares / total_weight());
}

Eigen::VectorXd flattened(std::span<const Vec3> points) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(3 * points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) x.segment<3>(static_cast<Eigen::Index>(3 * i)) = points[i];
  return x;
}

std::vector<Vec3> unflattened(const Eigen::VectorXd& x) {
  FORAMEN_ASSERT(x.size() % 3 == 0);
  std::vector<Vec3> points(x.size() / 3);
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = x.segment<3>(static_cast<Eigen::Index>(3 * i));
  return points;
}

ShapeModel model_of_aligned(const std::vector<std::vector<Vec3>>& aligned,
                            std::vector<std::array<int, 3>> triangles, std::vector<double> weights) {
  check_shapes(aligned);
  check_weights(weights, static_cast<int>(aligned[0].size()));
  const Eigen::VectorXd mean = mean_of(aligned);
  Eigen::MatrixXd x = centred_columns(aligned, mean);
  Eigen::VectorXd scaled_mean = mean;
  scale_rows(x, weights);
  scale_rows(scaled_mean, weights);
  const double divisor = static_cast<double>(aligned.size() - 1);

  // The bound for rounding follows the size of the coordinates: the norm of the mean or, if larger, of the
  // variation.
  const double rounding = rounding_of_shapes * std::max(scaled_mean.norm(), x.norm() / std::sqrt(divisor));
  Modes modes =
      principal_modes(x, divisor, x.cols() - 1,
                      {.absolute = rounding * rounding, .relative_to_first = smallest_variance_ratio});
  unscale_rows(modes.basis, weights);
  fix_signs(modes.basis);
  return ShapeModel(mean, std::move(modes.basis), std::move(modes.variance), std::move(triangles),
                    std::move(weights));
}

ShapeModel reweighted(const ShapeModel& model, std::vector<double> weights) {
  check_weights(weights, model.landmarks());
  if (model.modes() == 0)
    return ShapeModel(model.mean(), model.basis(), model.variance(), model.triangles(), std::move(weights));
  Eigen::MatrixXd x = model.basis() * model.variance().cwiseSqrt().asDiagonal();
  scale_rows(x, weights);
  Modes modes = principal_modes(x, 1, x.cols(), {});
  unscale_rows(modes.basis, weights);
  fix_signs(modes.basis);
  return ShapeModel(model.mean(), std::move(modes.basis), std::move(modes.variance), model.triangles(),
                    std::move(weights));
}

}  // namespace foramen
