#pragma once
/// \file
/// Generalization and specificity in the form of the paper: an ensemble drawn from the model is compared with
/// the training set.

#include <vector>

#include "foramen/evaluate/specificity.hpp"

namespace foramen {

struct EnsembleAtModes {
  int modes = 0;
  /// Mean over training shapes of the smallest Hausdorff distance to a draw, mm. This is in-sample, because
  /// the model was built from these shapes.
  Estimate generalization;
  Estimate specificity;  ///< mean over draws of the smallest Hausdorff distance to a training shape, mm
};

/// foramen's interpretation of "we sampled 1000 normally distributed model instances and compared them to the
/// training set using the Hausdorff metric" \cite becker2011. \pre the specificity was computed with its
/// Hausdorff distances
std::vector<EnsembleAtModes> ensemble_form(const Specificity& specificity);

}  // namespace foramen
