#pragma once
/// \file
/// The posterior distribution of shapes given noisy positions of some landmarks.

#include <span>

#include "foramen/apply/shape_distribution.hpp"

namespace foramen {

/// A noisy observation of a landmark: place = x_landmark + error with error ~ N(0, precision^-1). The
/// precision may be singular; its null space is not observed, for example the directions in a plane.
struct LandmarkObservation {
  int landmark = 0;
  Vec3 place = Vec3::Zero();
  Mat3 precision = Mat3::Zero();  ///< mm^-2, symmetric, positive semi-definite
};

/// The posterior of the coefficients: a ~ N(mean, spread spread^T).
struct PosteriorCoefficients {
  Eigen::VectorXd mean;    ///< K
  Eigen::MatrixXd spread;  ///< K x K
};

/// The posterior of x = m + F a with a ~ N(0, I) after \cite albrecht2013, Section 3, but with an own
/// precision W_o for every observation o instead of one sigma. With the three rows F_o of its landmark it is
///
///     M = I + sum_o F_o^T W_o F_o,   E[a] = M^-1 sum_o F_o^T W_o (place_o - m_o),   Cov[a] = M^-1.
///
/// For W = I / sigma^2 this equals M = Q^T Q + sigma^2 I of the paper up to the factor sigma^2. A landmark
/// may be observed any number of times. Without observations the result is the prior. Throws InvalidInput for
/// a landmark that does not exist.
PosteriorCoefficients posterior_coefficients(const ShapeDistribution& prior,
                                             std::span<const LandmarkObservation> observations);

/// The distribution of shapes for these coefficients: mean m + F E[a], factor F spread.
ShapeDistribution posterior(const ShapeDistribution& prior, const PosteriorCoefficients& coefficients);

}  // namespace foramen
