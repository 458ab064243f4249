#pragma once
/// \file
/// The paper's form of both measures: an ensemble drawn from the model against the training set.

#include <vector>

#include "foramen/evaluate/specificity.hpp"

namespace foramen {

struct EnsembleAtModes {
  int modes = 0;
  Estimate generalization;  ///< over training shapes: smallest Hausdorff distance to a draw, mm. In-sample:
                            ///< the model has seen them.
  Estimate specificity;     ///< over draws: smallest Hausdorff distance to a training shape, mm
};

/// Our reading of "we sampled 1000 normally distributed model instances and compared them to the training set
/// using the Hausdorff metric" \cite becker2011. \pre the specificity was computed with its Hausdorff
/// distances
std::vector<EnsembleAtModes> ensemble_form(const Specificity& specificity);

}  // namespace foramen
