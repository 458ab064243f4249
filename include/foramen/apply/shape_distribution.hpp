#pragma once
/// \file
/// A normal distribution of shapes with an arbitrary linear factor, more general than a ShapeModel with
/// orthonormal modes.

#include <array>
#include <vector>

#include <Eigen/Core>

#include "foramen/match/bending_options.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

/// x = mean + factor a with a ~ N(0, I), mm: the covariance of the shapes is factor factor^T.
struct ShapeDistribution {
  Eigen::VectorXd mean;    ///< 3P
  Eigen::MatrixXd factor;  ///< 3P x K, any K
  int landmarks() const { return static_cast<int>(mean.size() / 3); }
};

/// The distribution of a model: factor = basis diag(sqrt(variance)).
ShapeDistribution distribution_of(const ShapeModel& model);

/// The distribution with additional columns of the factor, that is, the sum of two independent displacements.
/// \pre as many rows
ShapeDistribution with_columns(ShapeDistribution distribution, const Eigen::MatrixXd& columns);

/// 3P x 3R columns \f$ \sqrt{share}\, \phi_k(x_i) e_c \f$ of independent smooth displacements of the
/// coordinates c, where phi_k are the functions of smooth_displacements() at the landmarks, without common
/// translations and linear maps. They describe deformations beyond the modes of a model \cite luethi2018.
/// \param share  factor of the variance, > 0
Eigen::MatrixXd smooth_columns(const Eigen::VectorXd& mean, double share,
                               const SmoothDisplacementOptions& options);

/// For each landmark the square root of the trace of its covariance, mm, that is, the RMS distance from its
/// mean.
std::vector<double> standard_deviations(const ShapeDistribution& distribution);

/// The same distribution as a model with orthonormal modes. Modes with less than 1e-6 of the total variance
/// are dropped.
ShapeModel principal_model(const ShapeDistribution& distribution, std::vector<std::array<int, 3>> triangles);

}  // namespace foramen
