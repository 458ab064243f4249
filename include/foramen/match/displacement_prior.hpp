#pragma once
/// \file
/// The prior distribution of a displacement.

#include <Eigen/Core>

namespace foramen {

/// A normal distribution \f$ a \sim N(m, v I + D D^T) \f$ of the coefficients of the R functions of
/// smooth_displacements(), stacked by coordinate (all of x, all of y, all of z). The default is the
/// distribution of the smooth process itself.
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

/// Converts a prior to its quadratic form. Throws InvalidInput for sizes that do not agree and for a variance
/// that is not > 0.
/// \param coefficients  the number of coefficients, 3 R
PriorForm prior_form(const DisplacementPrior& prior, Eigen::Index coefficients);

}  // namespace foramen
