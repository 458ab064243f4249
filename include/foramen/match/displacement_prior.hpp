#pragma once
/// \file
/// What is known of a displacement before its shape is seen.

#include <Eigen/Core>

namespace foramen {

/// A normal distribution of the coefficients of smooth_displacements(), R functions, stacked by coordinate
/// (all of x, all of y, all of z): \f$ a \sim N(m, v I + D D^T) \f$. As it is made here: the smooth process
/// itself.
struct DisplacementPrior {
  double variance = 1;              ///< v, > 0
  Eigen::VectorXd mean = {};        ///< m, 3 R; empty: zero
  Eigen::MatrixXd directions = {};  ///< D, 3 R x k; empty: none
};

/// The quadratic form of a prior: \f$ \log p(a) = -\frac12 a^T P a + q^T a + const \f$.
struct PriorForm {
  Eigen::MatrixXd precision;  ///< P = (v I + D D^T)^-1
  Eigen::VectorXd pull;       ///< q = P m
};

/// \param coefficients  3 R. Throws InvalidInput for sizes that do not fit, or a variance that is not > 0.
PriorForm prior_form(const DisplacementPrior& prior, Eigen::Index coefficients);

}  // namespace foramen
