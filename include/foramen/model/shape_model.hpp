#pragma once
/// \file
/// The statistical shape model: x = mean + basis * b, b_m ~ N(0, variance_m) \cite cootes1995, in the inner
/// product of the landmarks' weights, <x, y> = sum_i w_i x_i . y_i; without weights all w_i are 1.

#include <array>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {

class ShapeModel {
 public:
  ShapeModel() = default;
  /// \param basis  3P x K, columns orthonormal in the weights' inner product  \param variance  K, mm^2,
  /// decreasing, divisor n - 1  \param weights  P, > 0, or empty  Throws InvalidInput if these do not fit
  /// together.
  ShapeModel(Eigen::VectorXd mean, Eigen::MatrixXd basis, Eigen::VectorXd variance,
             std::vector<std::array<int, 3>> triangles, std::vector<double> weights = {});

  int modes() const { return static_cast<int>(variance_.size()); }
  int landmarks() const { return static_cast<int>(mean_.size() / 3); }
  const Eigen::VectorXd& mean() const { return mean_; }
  const Eigen::MatrixXd& basis() const { return basis_; }
  const Eigen::VectorXd& variance() const { return variance_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }
  /// One per landmark; empty if all count alike.
  const std::vector<double>& weights() const { return weights_; }
  /// Sum of the weights: the number of landmarks if all count alike. What a variance is divided by to be one
  /// of a landmark.
  double total_weight() const;

  /// mean + the first b.size() modes. b in mm (not in standard deviations).
  Eigen::VectorXd reconstruct(const Eigen::VectorXd& b) const;
  /// Scores of an aligned shape on the first `modes` modes, mm: those of the closest reconstruction in the
  /// weights' inner product.
  Eigen::VectorXd scores(const Eigen::VectorXd& shape, int modes) const;
  /// b ~ N(0, variance) for all modes, mm. Truncate for fewer.
  Eigen::VectorXd draw(Rng& rng) const;
  /// mean +- sd standard deviations along one mode.
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

/// x0 y0 z0 x1 ... of points, and back.
Eigen::VectorXd flattened(std::span<const Vec3> points);
std::vector<Vec3> unflattened(const Eigen::VectorXd& x);

/// PCA of aligned corresponding shapes: covariance with divisor n - 1, by the Gram matrix,
/// re-orthonormalised; modes below 1e-10 of the first are dropped; the largest component of each mode is
/// positive. With weights (one per landmark, > 0) that of the coordinates times the roots of their weights:
/// the variances sum to \f$ \frac{1}{n-1} \sum_s \sum_i w_i |x_{si} - \bar x_i|^2 \f$. \pre at least 2 shapes
/// of the same length
ShapeModel model_of_aligned(const std::vector<std::vector<Vec3>>& aligned,
                            std::vector<std::array<int, 3>> triangles, std::vector<double> weights = {});

/// The same distribution of shapes, basis * diag(variance) * basis^T, in modes that are orthonormal under
/// other weights (empty: all alike).
ShapeModel reweighted(const ShapeModel& model, std::vector<double> weights);

}  // namespace foramen
