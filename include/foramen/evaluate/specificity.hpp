#pragma once
/// \file
/// Specificity: how close shapes drawn from the model are to real ones; and the same draws read the paper's
/// way.

#include <cstdint>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"

namespace foramen {

struct SpecificityOptions {
  int draws = 1000;            ///< shapes drawn from the model, > 0
  std::uint64_t seed = 1;      ///< of the draws, and of the samples of surfaces
  int surface_samples = 2000;  ///< of each surface for its distances, > 0
  bool hausdorff = true;       ///< Unset: these distances are left 0, and so is the ensemble form.
  bool mean_surface = true;    ///< Unset: these distances are left 0.
};

struct Specificity {
  std::vector<ErrorsAtModes>
      by_modes;  ///< items: one per draw, each distance to the shape closest in that distance
  /// At each number of modes, for each training shape: the smallest Hausdorff distance to a draw, mm.
  std::vector<std::vector<double>> nearest_draw;
};

/// \f$ S(M) = \frac{1}{K} \sum_k \min_i d(\mathrm{input}_i, \bar x + \sum_{m \le M} b_{km} \phi_m) \f$, b_km
/// ~ N(0, variance_m) \cite davies2008. The draws are made once, each from its own stream, and truncated to M
/// modes; those beyond +-3 sd are kept. Distances are to the original input surfaces. The search for the
/// closest shape leaves out what exact bounds exclude; the result is that of comparing all with all. The same
/// bytes for any number of threads. M runs over mode_counts(last_mode).
Specificity specificity(const AlignedCohort& cohort, int last_mode, const SpecificityOptions& options,
                        const RunContext& ctx);

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
