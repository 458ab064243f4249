#include "foramen/evaluate/truth_error.hpp"

#include <algorithm>
#include <numeric>
#include <string>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "spatial/percentile.hpp"

namespace foramen {
namespace {

/// Landmarks of every shape.
using Landmarks = std::vector<std::vector<Vec3>>;
/// Errors of the landmarks of one shape on all others, in the order of partners and landmarks.
using Errors = std::vector<double>;

void check_truth(const CorrespondingCohort& cohort, const TrueCorrespondence& truth) {
  if (truth.shapes.size() != cohort.corresponding.size())
    throw InvalidInput("the true correspondence has " + std::to_string(truth.shapes.size()) +
                       " shapes, the cohort " + std::to_string(cohort.size()) +
                       ": give the truth of the same shapes in the same order");
  for (std::size_t s = 0; s < truth.shapes.size(); ++s)
    if (truth.shapes[s].size() != truth.shapes[0].size())
      throw InvalidInput("the truth of " + cohort.names[s] + " has " +
                         std::to_string(truth.shapes[s].size()) + " vertices, that of " + cohort.names[0] +
                         " " + std::to_string(truth.shapes[0].size()) +
                         ": true meshes must have the same vertices in the same order");
}

/// The true correspondence as a map of points between shapes.
class TrueMap {
 public:
  TrueMap(const TrueCorrespondence& truth, const RunContext& ctx) : meshes_(truth.shapes.size()) {
    parallel_for(static_cast<int>(truth.shapes.size()), ctx, [&](int s) {
      meshes_[s] = build_mesh({truth.shapes[s], truth.triangles});
    });
  }
  /// The points of the truth mesh of shape `from` that are closest to the given points.
  std::vector<SurfacePoint> places(const std::vector<Vec3>& points, std::size_t from) const {
    const TriangleTree tree(meshes_[from]);
    std::vector<SurfacePoint> on;
    on.reserve(points.size());
    for (const Vec3& p : points) on.push_back(tree.closest(p).on);
    return on;
  }
  Vec3 at(const SurfacePoint& place, std::size_t shape) const { return position(meshes_[shape], place); }

 private:
  std::vector<Mesh> meshes_;
};

/// Maps all landmarks of every shape to every other shape and compares them with the landmarks there.
std::vector<Errors> errors_of(const Landmarks& landmarks, const TrueMap& map, const RunContext& ctx) {
  std::vector<Errors> errors(landmarks.size());
  parallel_for(static_cast<int>(landmarks.size()), ctx, [&](int shape) {
    const std::size_t from = shape;
    const auto places = map.places(landmarks[from], from);
    for (std::size_t to = 0; to < landmarks.size(); ++to)
      for (std::size_t i = 0; i < places.size() && to != from; ++i)
        errors[from].push_back((map.at(places[i], to) - landmarks[to][i]).norm());
  });
  return errors;
}

double mean_of(const Errors& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

ErrorSummary summary(const std::vector<Errors>& by_shape) {
  Errors all;
  for (const Errors& e : by_shape) all.insert(all.end(), e.begin(), e.end());
  ErrorSummary s;
  s.mean = mean_of(all);
  s.p95 = detail::percentile_95(all);
  s.max = *std::max_element(all.begin(), all.end());
  return s;
}

/// The landmarks of the first shape, mapped to each shape by the true correspondence and projected to its
/// input surface.
Landmarks carried_landmarks(const CorrespondingCohort& cohort, const TrueMap& map, const RunContext& ctx) {
  const auto places = map.places(cohort.corresponding[0], 0);
  Landmarks landmarks(cohort.corresponding.size());
  parallel_for(cohort.size(), ctx, [&](int shape) {
    const std::size_t s = shape;
    const TriangleTree input(cohort.inputs[s]);
    for (const SurfacePoint& place : places) landmarks[s].push_back(input.closest(map.at(place, s)).point);
  });
  return landmarks;
}

}  // namespace

TruthError truth_error(const CorrespondingCohort& cohort, const TrueCorrespondence& truth,
                       const RunContext& ctx) {
  check_cohort(cohort);
  check_truth(cohort, truth);
  const TrueMap map(truth, ctx);
  const std::vector<Errors> errors = errors_of(cohort.corresponding, map, ctx);
  TruthError result;
  result.error = summary(errors);
  for (const Errors& e : errors) result.mean_from_shape.push_back(mean_of(e));
  result.floor = summary(errors_of(carried_landmarks(cohort, map, ctx), map, ctx));
  return result;
}

std::vector<std::vector<Vec3>> true_landmarks(const CorrespondingCohort& cohort,
                                              const TrueCorrespondence& truth, const RunContext& ctx) {
  check_cohort(cohort);
  check_truth(cohort, truth);
  return carried_landmarks(cohort, TrueMap(truth, ctx), ctx);
}

}  // namespace foramen
