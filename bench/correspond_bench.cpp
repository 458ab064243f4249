// Rigid alignment and the ICP baseline on real vertebrae of two subjects, or on tori if there is no real
// data.

#include <benchmark/benchmark.h>

#include <cmath>

#include "correspond/icp_baseline.hpp"
#include "foramen/match/align.hpp"
#include "support/meshes.hpp"
#include "support/real_meshes.hpp"

namespace foramen {
namespace {

Mesh torus_of(int vertices, std::uint64_t seed) {
  const int tube = static_cast<int>(std::sqrt(vertices / 2.0));
  return build_mesh(testing::bumpy_torus_soup(2 * tube, tube, seed));
}

Mesh vertebra(const char* name, std::uint64_t seed) {
  return std::filesystem::is_directory(testing::data_dir() / "lumbar") ? testing::real_mesh(name)
                                                                       : torus_of(30000, seed);
}

void align_tori(benchmark::State& state) {
  const int vertices = static_cast<int>(state.range(0));
  const Mesh moving = torus_of(vertices, 1), fixed = torus_of(vertices, 2);
  for (auto _ : state) benchmark::DoNotOptimize(align(moving, fixed, RunContext(1)).residual);
  state.SetComplexityN(state.range(0));
}
BENCHMARK(align_tori)->RangeMultiplier(2)->Range(2500, 50000)->Unit(benchmark::kMillisecond)->Complexity();

void align_vertebrae(benchmark::State& state) {
  const Mesh moving = vertebra("lumbar/verse581_L1", 1), fixed = vertebra("lumbar/verse005_L2", 2);
  int iterations = 0;
  for (auto _ : state) iterations = align(moving, fixed, RunContext(1)).iterations;
  state.counters["iterations"] = iterations;
  state.counters["vertices"] = moving.vertex_count();
}
BENCHMARK(align_vertebrae)->Unit(benchmark::kMillisecond);

void icp_baseline_of_4000_landmarks(benchmark::State& state) {
  const Mesh reference = vertebra("lumbar/verse005_L2", 2), shape = vertebra("lumbar/verse581_L1", 1);
  const RigidTransform to_reference = align(shape, reference, RunContext(1)).transform;
  const VertexMap<Vec3> vertex_normal = vertex_normals(reference);
  std::vector<Vec3> landmarks, normals;
  for (int v = 0; v < reference.vertex_count(); v += std::max(1, reference.vertex_count() / 4000)) {
    landmarks.push_back(reference.position(VertexId(v)));
    normals.push_back(vertex_normal[VertexId(v)]);
  }
  const TriangleTree tree(shape);
  for (auto _ : state)
    benchmark::DoNotOptimize(icp_correspondence(landmarks, normals, tree, to_reference).points.data());
}
BENCHMARK(icp_baseline_of_4000_landmarks)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace foramen
