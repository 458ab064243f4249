#pragma once
/// \file
/// The statistical shape model: x = mean + basis * b, b_m ~ N(0, variance_m) (Cootes et al. 1995).

#include <array>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {

class ShapeModel {
 public:
  ShapeModel() = default;
  /// \param basis  3P x K, orthonormal columns  \param variance  K, mm^2, decreasing, divisor n - 1
  ShapeModel(Eigen::VectorXd mean, Eigen::MatrixXd basis, Eigen::VectorXd variance,
             std::vector<std::array<int, 3>> triangles);

  int modes() const { return static_cast<int>(variance_.size()); }
  int landmarks() const { return static_cast<int>(mean_.size() / 3); }
  const Eigen::VectorXd& mean() const { return mean_; }
  const Eigen::MatrixXd& basis() const { return basis_; }
  const Eigen::VectorXd& variance() const { return variance_; }
  const std::vector<std::array<int, 3>>& triangles() const { return triangles_; }

  /// mean + the first b.size() modes. b in mm (not in standard deviations).
  Eigen::VectorXd reconstruct(const Eigen::VectorXd& b) const;
  /// Scores of an aligned shape on the first `modes` modes, mm.
  Eigen::VectorXd scores(const Eigen::VectorXd& shape, int modes) const;
  /// b ~ N(0, variance) for all modes, mm. Truncate for fewer.
  Eigen::VectorXd draw(Rng& rng) const;
  /// mean +- sd standard deviations along one mode.
  Eigen::VectorXd along_mode(int mode, double sd) const;

 private:
  Eigen::VectorXd mean_;
  Eigen::MatrixXd basis_;
  Eigen::VectorXd variance_;
  std::vector<std::array<int, 3>> triangles_;
};

/// x0 y0 z0 x1 ... of points, and back.
Eigen::VectorXd flattened(std::span<const Vec3> points);
std::vector<Vec3> unflattened(const Eigen::VectorXd& x);

/// PCA of aligned corresponding shapes: covariance with divisor n - 1, by the Gram matrix,
/// re-orthonormalised; modes below 1e-10 of the first are dropped; the largest component of each mode is
/// positive. \pre at least 2 shapes of the same length
ShapeModel build_shape_model(const std::vector<std::vector<Vec3>>& aligned,
                             std::vector<std::array<int, 3>> triangles);

}  // namespace foramen
