#include <benchmark/benchmark.h>

#include "foramen/synth/synth_cohort.hpp"

namespace foramen {
namespace {

// The time to make one shape on one thread, by its number of vertices.
void synth_one_shape(benchmark::State& state) {
  SynthOptions options;
  options.shapes = 1;
  options.vertices = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(synth_cohort(options, RunContext(1)));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(synth_one_shape)
    ->RangeMultiplier(2)
    ->Range(2500, 40000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity();

}  // namespace
}  // namespace foramen
