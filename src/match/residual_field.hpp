#pragma once
/// \file
/// A displacement that the smooth process leaves out: a random field on the template's surface itself.

#include <vector>

#include <Eigen/SparseCore>

#include "match/two_way_matches.hpp"

namespace foramen {

/// The Matern field r of smoothness 1 on a surface, as the solution of a stochastic differential equation
/// \cite lindgren2011. Each coordinate has the negative log density, up to a constant,
///
///     1/2 E(r),   E(r) = 1 / (4 pi l^2 s^2) integral |r - l^2 Laplace r|^2 dA,
///
/// with the correlation length l and, on a plane, the standard deviation s. The Laplacian is that of cotangents,
/// which are limited to [0, 5].
class ResidualField {
 public:
  /// \param length_mm  l > 0
  /// \param amplitude_mm  s > 0
  ResidualField(const Mesh& surface, double length_mm, double amplitude_mm);

  /// The displacement that is most probable given the pulls, one row per vertex, by conjugate gradients.
  /// \param start  a first guess
  Eigen::MatrixX3d most_probable(const std::vector<VertexPull>& pulls, const Eigen::MatrixX3d& start) const;

 private:
  using Sparse = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  Eigen::VectorXd area_;      // of each vertex
  Sparse operator_;           // area (1 - l^2 Laplace), symmetric
  Eigen::VectorXd diagonal_;  // of the precision
  double factor_;             // 1 / (4 pi l^2 s^2)
};

}  // namespace foramen
