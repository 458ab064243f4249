#pragma once
/// \file
/// Compactness: how much of the variance of the shapes the first modes explain.

#include <vector>

#include "foramen/model/shape_model.hpp"

namespace foramen {

/// The compactness of the first modes.
struct CompactnessAtModes {
  int modes = 0;
  double variance_per_landmark = 0;  ///< (1 / total weight) sum of the first M variances, mm^2
  double fraction = 0;               ///< of the total variance, 0 .. 1
};

/// \f$ C(M) = \frac{1}{\sum_i w_i} \sum_{m \le M} \lambda_m \f$ for mode_counts(last_mode) \cite davies2008,
/// with the landmark weights w_i (all 1 without weights). The variances have the divisor n - 1. Modes beyond
/// those of the model have variance 0. A model without variation has fraction 1. Compactness is not
/// meaningful on its own, because loss of detail improves it.
std::vector<CompactnessAtModes> compactness(const ShapeModel& model, int last_mode);

}  // namespace foramen
