#pragma once
/// \file
/// Compactness: how much of the shapes' variation the first modes hold.

#include <vector>

#include "foramen/model/shape_model.hpp"

namespace foramen {

struct CompactnessAtModes {
  int modes = 0;
  double variance_per_landmark = 0;  ///< (1 / total weight) sum of the first M variances, mm^2
  double fraction = 0;               ///< of the total variance, 0 .. 1
};

/// \f$ C(M) = \frac{1}{\sum_i w_i} \sum_{m \le M} \lambda_m \f$ for mode_counts(last_mode) \cite davies2008,
/// w_i the landmarks' weights: their number if all count alike. Variances have the divisor n - 1. Modes the
/// model does not have hold no variance. A model without variation has fraction 1. Loss of detail improves
/// compactness: it says nothing alone.
std::vector<CompactnessAtModes> compactness(const ShapeModel& model, int last_mode);

}  // namespace foramen
