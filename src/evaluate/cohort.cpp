#include "foramen/evaluate/cohort.hpp"

#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

constexpr int every_mode_up_to = 20;

void check_count(std::size_t found, std::size_t shapes, const char* what) {
  if (found != shapes)
    throw InvalidInput("found " + std::to_string(found) + " " + what + " for " + std::to_string(shapes) +
                       " corresponding shapes: there must be one for each");
}

template <class Value>
Estimate estimate_of(const std::vector<ShapeError>& items, Value value) {
  std::vector<double> values;
  values.reserve(items.size());
  for (const ShapeError& e : items) values.push_back(value(e));
  return estimate(values);
}

}  // namespace

CorrespondingCohort corresponding_cohort(std::span<const Shape> shapes, const Landmarks& landmarks,
                                         std::vector<std::string> subjects) {
  CorrespondingCohort cohort{
      landmarks.names, std::move(subjects), landmarks.mesh.triangles, landmarks.points, {}};
  for (const std::string& name : landmarks.names) cohort.inputs.push_back(shape_named(shapes, name).mesh);
  return cohort;
}

void check_cohort(const CorrespondingCohort& cohort) {
  const std::size_t shapes = cohort.corresponding.size();
  if (cohort.size() < fewest_shapes)
    throw InvalidInput("an evaluation needs at least " + std::to_string(fewest_shapes) + " shapes, found " +
                       std::to_string(shapes));
  check_count(cohort.names.size(), shapes, "names");
  check_count(cohort.inputs.size(), shapes, "input surfaces");
  if (!cohort.subjects.empty()) check_count(cohort.subjects.size(), shapes, "subjects");
  for (std::size_t s = 0; s < shapes; ++s) {
    if (cohort.corresponding[s].size() != cohort.corresponding[0].size())
      throw InvalidInput(cohort.names[s] + " has " + std::to_string(cohort.corresponding[s].size()) +
                         " landmarks, " + cohort.names[0] + " has " +
                         std::to_string(cohort.corresponding[0].size()) +
                         ": corresponding meshes must have the same vertices in the same order");
    if (cohort.inputs[s].face_count() == 0)
      throw InvalidInput("the input surface of " + cohort.names[s] + " has no triangles");
  }
  if (cohort.triangles.empty()) throw InvalidInput("the corresponding meshes have no triangles");
  for (int s = 0; s < cohort.size(); ++s) corresponding_mesh(cohort, s);  // throws the errors of build_mesh()
}

Mesh corresponding_mesh(const CorrespondingCohort& cohort, int shape) {
  return build_mesh({cohort.corresponding[shape], cohort.triangles});
}

Mesh transformed(const Mesh& mesh, const SimilarityTransform& transform) {
  std::vector<Vec3> moved;
  moved.reserve(mesh.positions().size());
  for (const Vec3& p : mesh.positions()) moved.push_back(transform(p));
  return mesh.with_positions(std::move(moved));
}

AlignedCohort align_cohort(const CorrespondingCohort& cohort, ScaleMode scale, LandmarkWeights weights) {
  std::vector<double> of_landmarks = landmark_weights(cohort.corresponding, cohort.triangles, scale, weights);
  AlignedCohort aligned;
  aligned.alignment = procrustes(cohort.corresponding, scale, of_landmarks);
  for (std::size_t s = 0; s < cohort.inputs.size(); ++s)
    aligned.inputs.push_back(transformed(cohort.inputs[s], aligned.alignment.transforms[s]));
  aligned.model = model_of_aligned(aligned.alignment.aligned, cohort.triangles, std::move(of_landmarks));
  return aligned;
}

std::vector<int> mode_counts(int last) {
  std::vector<int> counts;
  for (int m = 1; m <= std::min(last, every_mode_up_to); ++m) counts.push_back(m);
  for (int m = 1; m < last; m *= 2)
    if (m > every_mode_up_to) counts.push_back(m);
  if (last > every_mode_up_to) counts.push_back(last);
  return counts;
}

Estimate estimate(const std::vector<double>& values) {
  FORAMEN_ASSERT(!values.empty());
  const auto n = static_cast<double>(values.size());
  Estimate e;
  e.mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  if (values.size() < 2) return e;
  double squares = 0;
  for (const double v : values) squares += (v - e.mean) * (v - e.mean);
  e.standard_error = std::sqrt(squares / (n - 1) / n);
  return e;
}

ErrorsAtModes errors_at_modes(int modes, std::vector<ShapeError> items) {
  ErrorsAtModes errors;
  errors.modes = modes;
  errors.hausdorff = estimate_of(items, [](const ShapeError& e) { return e.hausdorff; });
  errors.mean_surface = estimate_of(items, [](const ShapeError& e) { return e.mean_surface; });
  errors.landmark_rms = estimate_of(items, [](const ShapeError& e) { return e.landmark_rms; });
  errors.items = std::move(items);
  return errors;
}

}  // namespace foramen
