// Alignment and PCA of corresponding tori, by number of landmarks and by number of shapes. Both run on one
// thread.

#include <benchmark/benchmark.h>

#include <cmath>

#include "foramen/model/landmark_weights.hpp"
#include "foramen/model/procrustes.hpp"
#include "foramen/model/shape_model.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

constexpr std::int64_t usual_landmarks = 4000, usual_shapes = 14;

CorrespondingCohort cohort(const benchmark::State& state) {
  testing::TorusCohortOptions options;
  options.shapes = static_cast<int>(state.range(1));
  options.landmark_tube = static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)) / 2)));
  options.landmark_around = 2 * options.landmark_tube;
  return testing::torus_cohort(options);
}

void landmarks_and_shapes(benchmark::internal::Benchmark* b) {
  b->ArgNames({"landmarks", "shapes"});
  for (const int landmarks : {1000, 2000, 4000, 8000, 16000}) b->Args({landmarks, usual_shapes});
  for (const int shapes : {28, 56, 112}) b->Args({usual_landmarks, shapes});
  b->Unit(benchmark::kMillisecond);
}

void align_by_procrustes(benchmark::State& state) {
  const auto shapes = cohort(state).corresponding;
  int iterations = 0;
  for (auto _ : state) iterations = procrustes(shapes, ScaleMode::keep).iterations;
  state.counters["iterations"] = iterations;
}
BENCHMARK(align_by_procrustes)->Apply(landmarks_and_shapes);

void model_by_pca(benchmark::State& state) {
  const CorrespondingCohort made = cohort(state);
  const ProcrustesResult aligned = procrustes(made.corresponding, ScaleMode::keep);
  for (auto _ : state) benchmark::DoNotOptimize(model_of_aligned(aligned.aligned, made.triangles));
}
BENCHMARK(model_by_pca)->Apply(landmarks_and_shapes);

// A model with landmark weights, including the computation of the weights.
void weighted_model(benchmark::State& state) {
  const CorrespondingCohort made = cohort(state);
  for (auto _ : state) {
    const auto weights =
        landmark_weights(made.corresponding, made.triangles, ScaleMode::keep, LandmarkWeights::area);
    const ProcrustesResult aligned = procrustes(made.corresponding, ScaleMode::keep, weights);
    benchmark::DoNotOptimize(model_of_aligned(aligned.aligned, made.triangles, weights));
  }
}
BENCHMARK(weighted_model)->Apply(landmarks_and_shapes);

}  // namespace
}  // namespace foramen
