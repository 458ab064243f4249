// Every measure on corresponding tori with 4000 landmarks and the samples of a build, on one thread: by
// number of vertices of the input surfaces (for 4 shapes), and by number of shapes (of 10 000 vertices each).

#include <benchmark/benchmark.h>

#include <cmath>

#include "foramen/evaluate/generalization.hpp"
#include "foramen/evaluate/representation.hpp"
#include "foramen/evaluate/specificity.hpp"
#include "foramen/evaluate/truth_error.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

constexpr std::int64_t usual_vertices = 10000, fewest_shapes = 4;
constexpr int landmarks = 4000;
constexpr int draws = 20;  // a fiftieth of the number in a build

struct Quads {
  int around, tube;
};

// A torus with twice as many quads about the axis as about the tube.
Quads torus_of(std::int64_t vertices) {
  const int tube = static_cast<int>(std::lround(std::sqrt(static_cast<double>(vertices) / 2)));
  return {2 * tube, tube};
}

CorrespondingCohort cohort(const benchmark::State& state) {
  const Quads input = torus_of(state.range(0)), landmark = torus_of(landmarks);
  testing::TorusCohortOptions options;
  options.shapes = static_cast<int>(state.range(1));
  options.input_around = input.around;
  options.input_tube = input.tube;
  options.landmark_around = landmark.around;
  options.landmark_tube = landmark.tube;
  return testing::torus_cohort(options);
}

void vertices_and_shapes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"vertices", "shapes"});
  for (const int vertices : {2500, 5000, 10000, 25000, 50000}) b->Args({vertices, fewest_shapes});
  for (const int shapes : {7, 14, 28}) b->Args({usual_vertices, shapes});
  b->Unit(benchmark::kMillisecond);
}

void measure_generalization(benchmark::State& state) {
  const CorrespondingCohort made = cohort(state);
  for (auto _ : state) benchmark::DoNotOptimize(generalization(made, {}, RunContext(1)));
}
BENCHMARK(measure_generalization)->Apply(vertices_and_shapes);

void measure_specificity(benchmark::State& state, const SpecificityOptions& options) {
  const AlignedCohort made = align_cohort(cohort(state), ScaleMode::keep);
  const int last_mode = static_cast<int>(state.range(1)) - 1;
  for (auto _ : state) benchmark::DoNotOptimize(specificity(made, last_mode, options, RunContext(1)));
}

void specificity_hausdorff(benchmark::State& state) {
  measure_specificity(state, {.draws = draws, .mean_surface = false});
}
BENCHMARK(specificity_hausdorff)->Apply(vertices_and_shapes);

void specificity_mean_surface(benchmark::State& state) {
  measure_specificity(state, {.draws = draws, .hausdorff = false});
}
BENCHMARK(specificity_mean_surface)->Apply(vertices_and_shapes);

void measure_representation(benchmark::State& state) {
  const CorrespondingCohort made = cohort(state);
  const AlignedCohort aligned = align_cohort(made, ScaleMode::keep);
  for (auto _ : state)
    benchmark::DoNotOptimize(representation(made, aligned, {.samples = 20000}, RunContext(1)));
}
BENCHMARK(measure_representation)->Apply(vertices_and_shapes);

void measure_truth_error(benchmark::State& state) {
  const CorrespondingCohort made = cohort(state);
  const TrueCorrespondence truth{made.triangles, made.corresponding};
  for (auto _ : state) benchmark::DoNotOptimize(truth_error(made, truth, RunContext(1)));
}
BENCHMARK(measure_truth_error)->Apply(vertices_and_shapes);

}  // namespace
}  // namespace foramen
