#pragma once
/// \file
/// A normal distribution of shapes by any linear factor, for what a model of orthonormal modes does not hold.

#include <array>
#include <vector>

#include <Eigen/Core>

#include "foramen/match/bending_options.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

/// x = mean + factor a, a ~ N(0, I): shapes of covariance factor factor^T, mm.
struct ShapeDistribution {
  Eigen::VectorXd mean;    ///< 3P
  Eigen::MatrixXd factor;  ///< 3P x K, any K
  int landmarks() const { return static_cast<int>(mean.size() / 3); }
};

/// The model's: factor = basis diag(sqrt(variance)).
ShapeDistribution distribution_of(const ShapeModel& model);

/// The distribution with more columns: an independent sum of both displacements. \pre as many rows
ShapeDistribution with_columns(ShapeDistribution distribution, const Eigen::MatrixXd& columns);

/// 3P x 3R columns of a smooth displacement of every coordinate by itself, \f$ \sqrt{share}\, \phi_k(x_i)
/// e_c \f$, phi the functions of smooth_displacements() at the landmarks without its common translation and
/// linear map: what shapes have beyond a model's modes \cite luethi2018. \param share  of the variance, > 0
Eigen::MatrixXd smooth_columns(const Eigen::VectorXd& mean, double share,
                               const SmoothDisplacementOptions& options);

/// Root of the trace of each landmark's covariance, mm: the root mean square distance from the mean.
std::vector<double> standard_deviations(const ShapeDistribution& distribution);

/// The same distribution as a model with orthonormal modes, without those of less than 1e-6 of the total
/// variance.
ShapeModel principal_model(const ShapeDistribution& distribution, std::vector<std::array<int, 3>> triangles);

}  // namespace foramen
