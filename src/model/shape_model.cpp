#include "foramen/model/shape_model.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

constexpr double smallest_variance_ratio = 1e-10;  // modes below this part of the first are dropped
constexpr double rounding_of_shapes =
    1e-12;  // differences below this part of a shape's size are rounding, not variation

/// One shape a column, about the mean.
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

/// Makes column k orthonormal to the columns before it; twice is enough. False if nothing of it is left.
bool orthonormalise(Eigen::MatrixXd& basis, Eigen::Index k) {
  for (int pass = 0; pass < 2; ++pass) {
    for (Eigen::Index j = 0; j < k; ++j) basis.col(k) -= basis.col(j).dot(basis.col(k)) * basis.col(j);
    const double length = basis.col(k).norm();
    if (!(length > 0)) return false;
    basis.col(k) /= length;
  }
  return true;
}

/// The largest component is positive; of equal ones the first counts.
void fix_sign(Eigen::MatrixXd& basis, Eigen::Index k) {
  Eigen::Index largest = 0;
  basis.col(k).cwiseAbs().maxCoeff(&largest);
  if (basis(largest, k) < 0) basis.col(k) *= -1.0;
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
                       std::vector<std::array<int, 3>> triangles)
    : mean_(std::move(mean)),
      basis_(std::move(basis)),
      variance_(std::move(variance)),
      triangles_(std::move(triangles)) {
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
  return basis_.leftCols(modes_asked).transpose() * (shape - mean_);
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

Eigen::VectorXd flattened(std::span<const Vec3> points) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(3 * points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) x.segment<3>(static_cast<Eigen::Index>(3 * i)) = points[i];
  return x;
}

std::vector<Vec3> unflattened(const Eigen::VectorXd& x) {
  FORAMEN_ASSERT(x.size() % 3 == 0);
  std::vector<Vec3> points(static_cast<std::size_t>(x.size() / 3));
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = x.segment<3>(static_cast<Eigen::Index>(3 * i));
  return points;
}

ShapeModel build_shape_model(const std::vector<std::vector<Vec3>>& aligned,
                             std::vector<std::array<int, 3>> triangles) {
  check_shapes(aligned);
  const Eigen::VectorXd mean = mean_of(aligned);
  const Eigen::MatrixXd x = centred_columns(aligned, mean);
  const auto shapes = static_cast<Eigen::Index>(aligned.size());
  const double divisor = static_cast<double>(shapes - 1);

  // n x n in place of 3P x 3P: the eigenvectors of X^T X give those of X X^T.
  const Eigen::MatrixXd gram = x.transpose() * x / divisor;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(gram);
  if (eigen.info() != Eigen::Success)
    throw ConvergenceError("the eigenvalues of the shapes' Gram matrix were not found");

  // About the centroid: a cohort far from the origin has no more rounding to hide than its own digits.
  const double size = std::max(mean.norm(), x.norm() / std::sqrt(divisor));
  const double rounding_variance = (rounding_of_shapes * size) * (rounding_of_shapes * size);
  Eigen::MatrixXd basis(mean.size(), shapes - 1);
  Eigen::VectorXd variance(shapes - 1);
  Eigen::Index kept = 0;
  for (Eigen::Index k = 0; k < shapes - 1; ++k) {
    const Eigen::Index column = shapes - 1 - k;  // Eigen sorts upwards
    basis.col(kept) = x * eigen.eigenvectors().col(column);
    if (!orthonormalise(basis, kept)) continue;
    variance[kept] = (basis.col(kept).transpose() * x).squaredNorm() / divisor;
    const double smallest = kept == 0 ? rounding_variance : smallest_variance_ratio * variance[0];
    if (!(variance[kept] > std::max(smallest, rounding_variance))) break;
    fix_sign(basis, kept);
    ++kept;
  }
  return ShapeModel(mean, basis.leftCols(kept), variance.head(kept), std::move(triangles));
}

}  // namespace foramen
