#pragma once
/// \file
/// All measures of a cohort in correspondence.

#include <cstdint>
#include <optional>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/evaluate/compactness.hpp"
#include "foramen/evaluate/drawn_shapes.hpp"
#include "foramen/evaluate/generalization.hpp"
#include "foramen/evaluate/mark_transfer.hpp"
#include "foramen/evaluate/region_transfer.hpp"
#include "foramen/evaluate/representation.hpp"
#include "foramen/evaluate/specificity.hpp"
#include "foramen/evaluate/truth_error.hpp"

namespace foramen {

struct EvaluationOptions {
  ScaleMode scale = ScaleMode::keep;
  LandmarkWeights weights = LandmarkWeights::equal;
  int draws = 1000;
  int samples = 20000;
  int specificity_samples = 2000;
  std::uint64_t seed = 1;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<EvaluationOptions> auto& o) {
  visit(o.scale, {.name = "scale", .meaning = "keep or remove the shapes' size"});
  visit(o.weights,
        {.name = "landmark_weights", .meaning = "what landmarks count for: all alike, or by their area"});
  visit(o.draws, {.name = "draws",
                  .range = at_least(1).up_to(1000000),
                  .meaning = "random shapes for specificity, and for their own quality"});
  visit(o.samples, {.name = "surface_samples",
                    .range = at_least(1),
                    .meaning = "samples of each surface for its distances"});
  visit(o.specificity_samples, {.name = "specificity_surface_samples",
                                .range = at_least(1),
                                .meaning = "samples of each surface for the distances of specificity"});
  visit(o.seed, {.name = "seed", .meaning = "seed of all random numbers"});
}

/// Computing times, seconds.
struct EvaluationSeconds {
  double model = 0, representation = 0, generalization = 0, specificity = 0, drawn = 0, truth = 0, refit = 0;
};

/// The result of evaluate().
struct Evaluation {
  EvaluationOptions options;
  std::vector<std::string> names;
  std::vector<std::string> subjects;  ///< empty: not known
  int landmarks = 0;
  double total_variance = 0;  ///< per landmark, mm^2
  std::vector<CompactnessAtModes> compactness;
  Generalization leave_one_out;
  /// Unset: subjects are not known, or there are fewer than 2, or too few shapes remain without one.
  std::optional<Generalization> leave_subject_out;
  /// Unset: not requested. evaluate() does not compute them, because they need new builds, see
  /// refit_generalization().
  std::optional<RefitGeneralization> refit, refit_by_subject;
  Specificity specificity;
  std::vector<EnsembleAtModes> ensemble;
  DrawnShapes drawn;
  Representation representation;
  std::optional<TruthError> truth;  ///< unset: no truth was given
  /// Unset: nothing was marked. evaluate() does not compute them, see mark_transfer() and region_transfer().
  std::optional<MarkTransfer> marks;
  std::optional<RegionTransfer> regions;
  EvaluationSeconds seconds;  ///< computing times; the only part that differs between runs
};

/// Computes all measures as defined in docs/evaluation.md, except those of a refit, of marks and of
/// regions. Throws InvalidInput for fewer than 3 shapes and for a cohort that check_cohort() refuses.
Evaluation evaluate(const CorrespondingCohort& cohort, const EvaluationOptions& options,
                    const RunContext& ctx, const TrueCorrespondence* truth = nullptr);

}  // namespace foramen
