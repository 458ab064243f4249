#include "foramen/evaluate/evaluate.hpp"

#include <algorithm>
#include <chrono>
#include <map>

#include "core/freed_memory.hpp"

namespace foramen {
namespace {

/// Calls `work`, stores its time in `seconds` and returns freed memory to the system.
template <class Work>
auto timed(double& seconds, const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  auto result = work();
  return_freed_memory();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return result;
}

/// Whether subjects are known and at least two shapes remain without any one of them.
bool can_leave_subjects_out(const CorrespondingCohort& cohort) {
  if (cohort.subjects.empty()) return false;
  std::map<std::string, int> shapes_of;
  for (const std::string& s : cohort.subjects) ++shapes_of[s];
  const auto largest = std::max_element(shapes_of.begin(), shapes_of.end(),
                                        [](const auto& a, const auto& b) { return a.second < b.second; });
  return cohort.size() - largest->second >= 2;
}

}  // namespace

Evaluation evaluate(const CorrespondingCohort& cohort, const EvaluationOptions& options,
                    const RunContext& ctx, const TrueCorrespondence* truth) {
  check_cohort(cohort);
  Evaluation e;
  e.options = options;
  e.names = cohort.names;
  e.subjects = cohort.subjects;
  e.landmarks = cohort.landmarks();

  const AlignedCohort aligned =
      timed(e.seconds.model, [&] { return align_cohort(cohort, options.scale, options.weights); });
  const int last_mode = cohort.size() - 1;
  e.total_variance = aligned.model.variance().sum() / aligned.model.total_weight();
  e.compactness = compactness(aligned.model, last_mode);
  e.representation = timed(e.seconds.representation, [&] {
    return representation(cohort, aligned, {.samples = options.samples, .seed = options.seed}, ctx);
  });

  GeneralizationOptions leave_out{
      .scale = options.scale, .weights = options.weights, .samples = options.samples, .seed = options.seed};
  e.leave_one_out = timed(e.seconds.generalization, [&] { return generalization(cohort, leave_out, ctx); });
  leave_out.leave_out = LeaveOut::subject;
  if (can_leave_subjects_out(cohort))
    e.leave_subject_out =
        timed(e.seconds.generalization, [&] { return generalization(cohort, leave_out, ctx); });

  const SpecificityOptions drawing{
      .draws = options.draws, .seed = options.seed, .surface_samples = options.specificity_samples};
  e.specificity = timed(e.seconds.specificity, [&] { return specificity(aligned, last_mode, drawing, ctx); });
  e.ensemble = ensemble_form(e.specificity);
  e.drawn = timed(e.seconds.drawn, [&] {
    return drawn_shapes(aligned.model, {.draws = options.draws, .seed = options.seed}, ctx);
  });
  if (truth != nullptr) e.truth = timed(e.seconds.truth, [&] { return truth_error(cohort, *truth, ctx); });
  return e;
}

}  // namespace foramen
