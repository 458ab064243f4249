#include <benchmark/benchmark.h>

#include <cmath>

#include "simplify/working_mesh.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

// Simplification to a fifth of the vertices, as for a working mesh of 10 000 vertices of the largest
// vertebrae.
void simplify_to_a_fifth(benchmark::State& state) {
  const int tube = static_cast<int>(std::lround(std::sqrt(static_cast<double>(state.range(0)) / 2)));
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(2 * tube, tube, 1));
  const RunContext ctx(1);
  const SimplifyOptions options{.target_vertices = mesh.vertex_count() / 5};
  for (auto _ : state) benchmark::DoNotOptimize(simplify(mesh, ctx, options));
  state.counters["vertices"] = mesh.vertex_count();
  state.SetComplexityN(mesh.vertex_count());
}
BENCHMARK(simplify_to_a_fifth)
    ->Arg(2500)
    ->Arg(5000)
    ->Arg(10000)
    ->Arg(25000)
    ->Arg(50000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);

}  // namespace
}  // namespace foramen
