#include "foramen/evaluate/representation.hpp"

#include "core/parallel.hpp"
#include "evaluate/error_map.hpp"
#include "evaluate/stage_progress.hpp"
#include "spatial/flips.hpp"
#include "spatial/self_intersections.hpp"

namespace foramen {
namespace {

template <class Value>
Estimate estimate_of(const std::vector<ShapeRepresentation>& shapes, Value value) {
  std::vector<double> values;
  values.reserve(shapes.size());
  for (const ShapeRepresentation& s : shapes) values.push_back(static_cast<double>(value(s)));
  return estimate(values);
}

ShapeRepresentation measure(const CorrespondingCohort& cohort, const AlignedCohort& aligned, int shape,
                            const Mesh& mean, const SurfaceDistanceOptions& options) {
  const std::size_t s = shape;
  const Mesh corresponding = corresponding_mesh(cohort, shape);
  const TriangleTree surface(corresponding), input(cohort.inputs[s]);
  const SampledFlips flips = sampled_flips(corresponding, input);
  ShapeRepresentation result;
  result.distance = surface_distance(surface, input, options);
  result.plain_flips = static_cast<int>(flips.plain.size());
  result.confirmed_flips = static_cast<int>(flips.confirmed.size());
  result.degenerate = static_cast<int>(flips.degenerate.size());
  result.opposing_mean = opposing_mean(corresponding.with_positions(aligned.alignment.aligned[s]), mean);
  result.self_intersections = static_cast<int>(self_intersections(surface).size());
  result.input_self_intersections = static_cast<int>(self_intersections(input).size());
  result.map = error_map(surface, input, flips);
  return result;
}

}  // namespace

Representation representation(const CorrespondingCohort& cohort, const AlignedCohort& aligned,
                              const SurfaceDistanceOptions& options, const RunContext& ctx) {
  check_cohort(cohort);
  const Mesh mean = build_mesh({aligned.alignment.mean, cohort.triangles});
  Representation result;
  result.shapes.resize(cohort.corresponding.size());
  detail::StageProgress progress(ctx, "representation", cohort.size());
  parallel_for(cohort.size(), ctx, [&](int i) {
    result.shapes[i] = measure(cohort, aligned, i, mean, options);
    progress.finished_one();
  });
  result.mean_surface = estimate_of(result.shapes, [](const auto& s) { return s.distance.mean; });
  result.p95 = estimate_of(result.shapes, [](const auto& s) { return s.distance.p95; });
  result.hausdorff = estimate_of(result.shapes, [](const auto& s) { return s.distance.hausdorff; });
  result.plain_flips = estimate_of(result.shapes, [](const auto& s) { return s.plain_flips; });
  result.confirmed_flips = estimate_of(result.shapes, [](const auto& s) { return s.confirmed_flips; });
  result.opposing_mean = estimate_of(result.shapes, [](const auto& s) { return s.opposing_mean; });
  result.self_intersections = estimate_of(result.shapes, [](const auto& s) { return s.self_intersections; });
  result.input_self_intersections =
      estimate_of(result.shapes, [](const auto& s) { return s.input_self_intersections; });
  return result;
}

}  // namespace foramen
