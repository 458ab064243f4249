// The time of the searches for loops by number of vertices, on tori of revolution with noise of 2500 to 50
// 000 vertices.

#include <benchmark/benchmark.h>

#include <cmath>

#include "foramen/core/geometry.hpp"
#include "support/cut_open.hpp"
#include "support/double_torus.hpp"
#include "support/exhaustive_loops.hpp"
#include "topology/linking.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

constexpr int threads = 2;

// A torus with noise and twice as many quads about the axis as about the tube.
Mesh bumpy_torus(std::int64_t vertices) {
  const int tube = static_cast<int>(std::lround(std::sqrt(static_cast<double>(vertices) / 2)));
  return build_mesh(testing::bumpy_torus_soup(static_cast<int>(vertices / tube), tube, 1));
}

Mesh bumpy_double_torus(std::int64_t vertices) {
  const int tube = static_cast<int>(std::lround(std::sqrt(static_cast<double>(vertices) / 4)));
  return build_mesh(testing::bumpy_genus2_soup(static_cast<int>(vertices / 2 / tube), tube, 1));
}

void sizes(benchmark::internal::Benchmark* b) {
  for (int vertices : {2500, 5000, 10000, 22000, 50000}) b->Arg(vertices);
  b->Unit(benchmark::kMillisecond)->UseRealTime();
}

void greedy_loops_torus(benchmark::State& state) {
  const Mesh mesh = bumpy_torus(state.range(0));
  const auto lengths = edge_lengths(mesh);
  int v = 0;
  for (auto _ : state) {
    v = (v + 997) % mesh.vertex_count();
    benchmark::DoNotOptimize(greedy_loops(mesh, VertexId(v), lengths).length);
  }
}

void search(benchmark::State& state, const Mesh& mesh) {
  const auto lengths = edge_lengths(mesh);
  int evaluations = 0;
  for (auto _ : state) evaluations = shortest_loops(mesh, lengths, RunContext(threads)).evaluations;
  state.counters["evaluations"] = evaluations;
  state.counters["of_all_%"] = 100.0 * evaluations / mesh.vertex_count();
}

void shortest_loops_torus(benchmark::State& state) { search(state, bumpy_torus(state.range(0))); }
void shortest_loops_double_torus(benchmark::State& state) {
  search(state, bumpy_double_torus(state.range(0)));
}

// The exhaustive search, on meshes that are small enough for it.
void exhaustive_search(benchmark::State& state) {
  const Mesh mesh = bumpy_torus(state.range(0));
  const auto lengths = edge_lengths(mesh);
  for (auto _ : state)
    benchmark::DoNotOptimize(testing::shortest_loops_exhaustive(mesh, lengths, RunContext(threads)).length);
}

void cocycle_torus(benchmark::State& state) {
  const Mesh mesh = bumpy_torus(state.range(0));
  const LoopSystem loops = greedy_loops(mesh, VertexId(0), edge_lengths(mesh));
  for (auto _ : state) benchmark::DoNotOptimize(cocycle(mesh, loops));
}

void seifert_matrix_torus(benchmark::State& state) {
  const Mesh mesh = bumpy_torus(state.range(0));
  const LoopSystem loops = greedy_loops(mesh, VertexId(0), edge_lengths(mesh));
  for (auto _ : state) benchmark::DoNotOptimize(seifert_matrix(mesh, loops.loops[0], loops.loops[1]));
}

void cut_open_torus(benchmark::State& state) {
  const Mesh mesh = bumpy_torus(state.range(0));
  const LoopSystem loops = greedy_loops(mesh, VertexId(0), edge_lengths(mesh));
  for (auto _ : state) benchmark::DoNotOptimize(testing::cut_open(mesh, loops));
}

BENCHMARK(greedy_loops_torus)->Apply(sizes);
BENCHMARK(shortest_loops_torus)->Apply(sizes);
BENCHMARK(shortest_loops_double_torus)->Apply(sizes);
BENCHMARK(exhaustive_search)
    ->Arg(2500)
    ->Arg(5000)
    ->Arg(10000)
    ->Iterations(1)
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK(cocycle_torus)->Apply(sizes);
BENCHMARK(seifert_matrix_torus)->Apply(sizes);
BENCHMARK(cut_open_torus)->Apply(sizes);

}  // namespace
}  // namespace foramen
