// The time of torus maps of a bumpy torus, by number of vertices, on one thread.

#include <benchmark/benchmark.h>

#include <map>

#include "foramen/parameterize/torus_map.hpp"
#include "parameterize/mapped_torus.hpp"
#include "parameterize/optimise_map.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

using testing::MappedTorus;

const RunContext one_thread(1);

// The size of a grid of about this number of vertices, with twice as many round the axis as round the tube.
struct GridSize {
  int around, tube;
  explicit GridSize(std::int64_t vertices)
      : around(static_cast<int>(std::lround(std::sqrt(2.0 * static_cast<double>(vertices))))),
        tube(static_cast<int>(std::lround(std::sqrt(static_cast<double>(vertices) / 2)))) {}
};

const MappedTorus& torus(std::int64_t vertices) {
  static std::map<std::int64_t, MappedTorus> made;
  const auto found = made.find(vertices);
  if (found != made.end()) return found->second;
  const GridSize size(vertices);
  return made.emplace(vertices, testing::mapped_bumpy_torus(size.around, size.tube, 1)).first->second;
}

double best_energy(const MappedTorus& t) { return optimise_map(t.mesh, t.map, one_thread).final_energy; }

void HarmonicMap(benchmark::State& state) {
  const GridSize size(state.range(0));
  const Mesh& mesh = torus(state.range(0)).mesh;
  const Cocycle form = testing::grid_form(mesh, testing::regular_cells(size.around, size.tube));
  for (auto _ : state) benchmark::DoNotOptimize(harmonic_torus_map(mesh, form));
}

void Certificate(benchmark::State& state) {
  const MappedTorus& t = torus(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(certify(t.mesh, t.map));
}

void Newton(benchmark::State& state, const OptimiseMapOptions& options) {
  const MappedTorus& t = torus(state.range(0));
  OptimisedMap out;
  for (auto _ : state) out = optimise_map(t.mesh, t.map, one_thread, options);
  state.counters["iterations"] = out.iterations;
  state.counters["energy"] = out.final_energy;
}

// The time of either method until its energy is within this share above the energy at which Newton ends.
void ToShareAbove(benchmark::State& state, Optimiser method, double share) {
  const MappedTorus& t = torus(state.range(0));
  OptimiseMapOptions options;
  options.optimiser = method;
  options.stop_at_energy = (1 + share) * best_energy(t);
  options.relative_tolerance = 0;
  options.iteration_limit = 100000;
  OptimisedMap out;
  for (auto _ : state) out = optimise_map(t.mesh, t.map, one_thread, options);
  state.counters["iterations"] = out.iterations;
}

void register_all() {
  const auto sizes = [](benchmark::internal::Benchmark* b) {
    b->Arg(2500)->Arg(10000)->Arg(22000)->Arg(50000)->Unit(benchmark::kMillisecond);
  };
  OptimiseMapOptions one_iteration, free_lattice;
  one_iteration.iteration_limit = 1;
  free_lattice.free_lattice = true;
  sizes(benchmark::RegisterBenchmark("HarmonicMap", HarmonicMap));
  sizes(benchmark::RegisterBenchmark("Certificate", Certificate));
  sizes(benchmark::RegisterBenchmark("NewtonOneIteration", Newton, one_iteration));
  sizes(benchmark::RegisterBenchmark("Newton", Newton, OptimiseMapOptions{}));
  sizes(benchmark::RegisterBenchmark("NewtonFreeLattice", Newton, free_lattice));
  for (const double share : {0.1, 0.02}) {
    const std::string to = share == 0.1 ? "To10Percent" : "To2Percent";
    sizes(benchmark::RegisterBenchmark(("Newton" + to).c_str(), ToShareAbove, Optimiser::newton, share));
    sizes(benchmark::RegisterBenchmark(("PolakRibiere" + to).c_str(), ToShareAbove, Optimiser::polak_ribiere,
                                       share));
  }
}

const int registered = (register_all(), 0);

}  // namespace
}  // namespace foramen
