#include "foramen/evaluate/generalization.hpp"

#include <algorithm>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <utility>

#include "core/kept_results.hpp"
#include "core/parallel.hpp"
#include "evaluate/error_archive.hpp"
#include "evaluate/measured_surface.hpp"
#include "evaluate/pruned_distance.hpp"
#include "evaluate/stage_progress.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

AlignedModel model_without(const CorrespondingCohort& cohort, const std::vector<int>& group, ScaleMode scale,
                           const std::vector<double>& weights) {
  std::vector<std::vector<Vec3>> others;
  for (int i = 0; i < cohort.size(); ++i)
    if (std::find(group.begin(), group.end(), i) == group.end()) others.push_back(cohort.corresponding[i]);
  AlignedModel partial;
  partial.alignment = procrustes(others, scale, weights);
  partial.model = model_of_aligned(partial.alignment.aligned, cohort.triangles, weights);
  return partial;
}

void check(const CorrespondingCohort& cohort, const GeneralizationOptions& options) {
  check_options("generalization", options);
  if (options.leave_out == LeaveOut::subject && cohort.subjects.empty())
    throw InvalidInput(
        "generalization: subjects are not known, so none can be left out; name them, or leave out shapes");
}

}  // namespace

std::vector<std::vector<int>> left_out_together(int shapes, const std::vector<std::string>& subjects,
                                                LeaveOut leave_out) {
  std::vector<std::vector<int>> groups;
  std::vector<std::string> known_subjects;
  for (int i = 0; i < shapes; ++i) {
    if (leave_out == LeaveOut::shape) {
      groups.push_back({i});
      continue;
    }
    const std::string& subject = subjects[i];
    const auto known = std::find(known_subjects.begin(), known_subjects.end(), subject);
    if (known == known_subjects.end()) {
      known_subjects.push_back(subject);
      groups.push_back({i});
    } else {
      groups[known - known_subjects.begin()].push_back(i);
    }
  }
  return groups;
}

std::vector<ShapeError> unseen_errors(const std::vector<Vec3>& landmarks, const Mesh& input,
                                      const AlignedModel& aligned, const std::vector<int>& counts,
                                      const GeneralizationOptions& options) {
  const ShapeModel& model = aligned.model;
  const SimilarityTransform motion =
      align_to_mean(landmarks, aligned.alignment, options.scale, model.weights());
  Eigen::VectorXd truth(static_cast<Eigen::Index>(3 * landmarks.size()));
  for (std::size_t p = 0; p < landmarks.size(); ++p)
    truth.segment<3>(static_cast<Eigen::Index>(3 * p)) = motion(landmarks[p]);

  const Eigen::VectorXd scores = model.scores(truth, model.modes());
  const detail::MeasuredSurface original(transformed(input, motion), options.samples, options.seed);
  detail::MeasuredSurface fit(build_mesh({unflattened(model.mean()), model.triangles()}), options.samples,
                              options.seed);
  detail::FarthestClusters start;
  std::vector<ShapeError> errors;
  errors.reserve(counts.size());
  for (const int modes : counts) {
    const Eigen::VectorXd x = model.reconstruct(scores.head(std::min(modes, model.modes())));
    fit.move_to(unflattened(x));
    const std::vector<double> from_fit = sample_distances(fit, original),
                              from_input = sample_distances(original, fit);
    const double largest_sample = std::max(*std::max_element(from_fit.begin(), from_fit.end()),
                                           *std::max_element(from_input.begin(), from_input.end()));
    errors.push_back({detail::hausdorff_distance(fit, original, infinity, start, largest_sample),
                      0.5 * (detail::mean_of(from_fit) + detail::mean_of(from_input)),
                      model.landmark_rms(x, truth)});
  }
  return errors;
}

std::vector<ErrorsAtModes> over_shapes(const std::vector<std::vector<ShapeError>>& errors,
                                       const std::vector<int>& counts) {
  std::vector<ErrorsAtModes> by_modes;
  if (errors.empty()) return by_modes;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    std::vector<ShapeError> items;
    items.reserve(errors.size());
    for (const auto& of_shape : errors) items.push_back(of_shape[k]);
    by_modes.push_back(errors_at_modes(counts[k], std::move(items)));
  }
  return by_modes;
}

Generalization generalization(const CorrespondingCohort& cohort, const GeneralizationOptions& options,
                              const RunContext& ctx) {
  check_cohort(cohort);
  check(cohort, options);
  const auto groups = left_out_together(cohort.size(), cohort.subjects, options.leave_out);
  const auto largest = std::max_element(groups.begin(), groups.end(),
                                        [](const auto& a, const auto& b) { return a.size() < b.size(); });
  const int remaining = cohort.size() - static_cast<int>(largest->size());
  if (remaining < 2)
    throw InvalidInput("generalization: without " + cohort.subjects[largest->front()] + " only " +
                       std::to_string(remaining) + " shapes remain; a model needs 2");

  const std::vector<double> weights =
      landmark_weights(cohort.corresponding, cohort.triangles, options.scale, options.weights);
  const std::vector<int> counts = mode_counts(remaining - 1);
  std::vector<std::vector<ShapeError>> errors(cohort.corresponding.size());
  const StageKey of_cohort(ctx, "cohort", cohort.corresponding, cohort.triangles, cohort.inputs, options);
  detail::StageProgress progress(ctx, "generalization", cohort.size());
  // A model needs as much memory as all its shapes, and there is one per group. Therefore each model exists
  // only while its group is measured.
  parallel_for(static_cast<int>(groups.size()), ctx, [&](int g) {
    const std::vector<int>& group = groups[g];
    std::optional<AlignedModel> model;  // built for the first shape that is not in the store
    std::mutex making;
    const auto model_of_others = [&]() -> const AlignedModel& {
      const std::lock_guard lock(making);
      if (!model) model = model_without(cohort, group, options.scale, weights);
      return *model;
    };
    parallel_for(static_cast<int>(group.size()), ctx, [&](int k) {
      const int i = group[k];
      const std::size_t s = i;
      errors[s] = kept<std::vector<ShapeError>>(
          ctx, StageKey(ctx, "generalization", of_cohort, counts, group, i), [&] {
            return unseen_errors(cohort.corresponding[s], cohort.inputs[s], model_of_others(), counts,
                                 options);
          });
      progress.finished_one();
    });
  });

  return {options.leave_out, static_cast<int>(groups.size()), over_shapes(errors, counts)};
}

}  // namespace foramen
