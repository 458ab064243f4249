#pragma once
/// \file
/// The statistical shape model: x = mean + basis * b with b_m ~ N(0, variance_m) \cite cootes1995. The
/// columns of the basis are orthonormal in the weighted inner product <x, y> = sum_i w_i x_i . y_i of the
/// landmark weights w_i; without weights all w_i are 1.

#include <array>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {

/// A normal distribution of shapes with P landmarks in K modes. Immutable.
class ShapeModel {
 public:
  ShapeModel() = default;
  /// Throws InvalidInput if the sizes do not agree.
  /// \param mean  3P coordinates x0 y0 z0 x1 ... of the mean shape, mm
  /// \param basis  3P x K, columns orthonormal in the weighted inner product
  /// \param variance  K variances of the modes, mm^2, decreasing, with divisor n - 1
  /// \param weights  P landmark weights, > 0, or empty
  ShapeModel(Eigen::VectorXd mean, Eigen::MatrixXd basis, Eigen::VectorXd variance,
             std::vector<std::array<int, 3>> triangles, std::vector<double> weights = {});

  int modes() const { return static_cast<int>(variance_.size()); }
  int landmarks() const { return static_cast<int>(mean_.size() / 3); }
  const Eigen::VectorXd& mean() const { return mean_; }
  const Eigen::MatrixXd& basis() const { return basis_; }
  const Eigen::VectorXd& variance() const { return variance_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
  /// One weight per landmark; empty if all landmarks count the same.
  const std::vector<double>& weights() const { return weights_; }
  /// Sum of the weights; without weights the number of landmarks. The variance of a mode divided by it is the
  /// mean variance per landmark.
  double total_weight() const;

  /// The shape mean + sum of b_m times mode m over the first b.size() modes. b is in mm, not in standard
  /// deviations.
  Eigen::VectorXd reconstruct(const Eigen::VectorXd& b) const;
  /// Scores of an aligned shape on the first `modes` modes, mm: the coefficients of its orthogonal projection
  /// in the weighted inner product.
  Eigen::VectorXd scores(const Eigen::VectorXd& shape, int modes) const;
  /// Draws b ~ N(0, variance) for all modes, mm. To use fewer modes, truncate the result.
  Eigen::VectorXd draw(Rng& rng) const;
  /// The mean shape plus `sd` standard deviations of one mode; `sd` may be negative.
  Eigen::VectorXd along_mode(int mode, double sd) const;
  /// \f$ \sqrt{\sum_i w_i |a_i - b_i|^2 / \sum_i w_i} \f$, mm.
  double landmark_rms(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;

 private:
  Eigen::VectorXd mean_;
  Eigen::MatrixXd basis_;
  Eigen::VectorXd variance_;
  std::vector<std::array<int, 3>> triangles_;
  std::vector<double> weights_;
};

/// Coordinates x0 y0 z0 x1 ... of points as one vector; unflattened() is the inverse.
Eigen::VectorXd flattened(std::span<const Vec3> points);
std::vector<Vec3> unflattened(const Eigen::VectorXd& x);

/// Principal component analysis of n aligned corresponding shapes. The covariance has divisor n - 1; its
/// eigenvectors are computed by the n x n Gram matrix and orthonormalised again. Modes with a variance below
/// 1e-10 of the first or below rounding are dropped. The sign of a mode makes its largest component positive.
/// With weights (one per landmark, > 0) coordinates are multiplied by the square roots of the weights for the
/// analysis, so the variances sum to \f$ \frac{1}{n-1} \sum_s \sum_i w_i |x_{si} - \bar x_i|^2 \f$. \pre at
/// least 2 shapes of the same length
ShapeModel model_of_aligned(const std::vector<std::vector<Vec3>>& aligned,
                            std::vector<std::array<int, 3>> triangles, std::vector<double> weights = {});

/// The same distribution of shapes, that is the same mean and covariance basis * diag(variance) * basis^T,
/// with modes that are orthonormal under other weights (empty: all weights 1).
ShapeModel reweighted(const ShapeModel& model, std::vector<double> weights);

}  // namespace foramen
