#pragma once
/// \file
/// Specificity: how close shapes drawn from the model are to training shapes. The same draws serve the form
/// of the paper (ensemble_form()).

#include <cstdint>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"

namespace foramen {

struct SpecificityOptions {
  int draws = 1000;            ///< shapes drawn from the model, > 0
  std::uint64_t seed = 1;      ///< seed of the draws and of the surface samples
  int surface_samples = 2000;  ///< samples of each surface for distances, > 0
  bool hausdorff = true;       ///< If false, these distances and the ensemble form are 0.
  bool mean_surface = true;    ///< If false, these distances are 0.
};

/// The result of specificity().
struct Specificity {
  /// One item per draw: for each kind of distance, that to the training shape that is closest in it.
  std::vector<ErrorsAtModes> by_modes;
  /// For each number of modes and each training shape, the smallest Hausdorff distance to a draw, mm.
  std::vector<std::vector<double>> nearest_draw;
};

/// \f$ S(M) = \frac{1}{K} \sum_k \min_i d(\mathrm{input}_i, \bar x + \sum_{m \le M} b_{km} \phi_m) \f$, with
/// K draws b_km ~ N(0, variance_m) \cite davies2008, for M in mode_counts(last_mode). Each draw has its own
/// random stream and is truncated to M modes; draws beyond +-3 standard deviations are not rejected.
/// Distances are those to the original input surfaces. The search for the closest shape uses exact bounds to
/// skip comparisons, so the result is that of comparing all pairs. It does not depend on the number of
/// threads.
Specificity specificity(const AlignedCohort& cohort, int last_mode, const SpecificityOptions& options,
                        const RunContext& ctx);

/// Both measures in the form of the paper for one number of modes.
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
