#pragma once
/// \file
/// The distribution of shapes given noisy places of some landmarks.

#include <span>

#include "foramen/apply/shape_distribution.hpp"

namespace foramen {

/// Where a landmark was seen: place = x_landmark + error, error ~ N(0, precision^-1). A precision that is
/// singular (in a plane, say) leaves those directions unseen.
struct LandmarkObservation {
  int landmark = 0;
  Vec3 place = Vec3::Zero();
  Mat3 precision = Mat3::Zero();  ///< mm^-2, symmetric, positive semi-definite
};

/// The coefficients a given what was seen: a ~ N(mean, spread spread^T).
struct PosteriorCoefficients {
  Eigen::VectorXd mean;    ///< K
  Eigen::MatrixXd spread;  ///< K x K
};

/// The posterior of x = m + F a, a ~ N(0, I), \cite albrecht2013 Section 3, with an error of its own for
/// every observation o in place of one sigma: with F_o the three rows of its landmark and W_o its precision,
///
///     M = I + sum_o F_o^T W_o F_o,   E[a] = M^-1 sum_o F_o^T W_o (place_o - m_o),   Cov[a] = M^-1.
///
/// For W = I / sigma^2 that is the paper's M = Q^T Q + sigma^2 I up to the factor sigma^2. A landmark may be
/// seen any number of times. No observation: the prior. Throws InvalidInput for a landmark that is not there.
PosteriorCoefficients posterior_coefficients(const ShapeDistribution& prior,
                                             std::span<const LandmarkObservation> observations);

/// The shapes of those coefficients: mean m + F E[a], factor F spread.
ShapeDistribution posterior(const ShapeDistribution& prior, const PosteriorCoefficients& coefficients);

}  // namespace foramen
