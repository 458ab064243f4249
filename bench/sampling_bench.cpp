#include <benchmark/benchmark.h>

#include "foramen/core/rng.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/curvature_density.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/mapped_tori.hpp"
#include "sampling/refine_landmarks.hpp"
#include "sampling/remesh.hpp"

namespace foramen {
namespace {

int points(const benchmark::State& state) { return static_cast<int>(state.range(0)); }

void BM_make_torus_grid(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(make_torus_grid(Lattice::Identity(), points(state)));
}

void BM_build_locator(benchmark::State& state) {
  const auto m = testing::wavy_torus(points(state));
  for (auto _ : state) benchmark::DoNotOptimize(TorusLocator(m.mesh, m.map));
}

void BM_locate(benchmark::State& state) {
  const auto m = testing::wavy_torus(points(state));
  const TorusLocator locator(m.mesh, m.map);
  Rng rng(1);
  std::vector<Vec2> places;
  for (int i = 0; i < 4096; ++i) places.emplace_back(rng.uniform(), rng.uniform());
  std::size_t i = 0;
  for (auto _ : state) benchmark::DoNotOptimize(locator.locate(places[i++ % places.size()]));
}

void BM_curvature_density(benchmark::State& state) {
  const auto m = testing::wavy_torus(points(state));
  for (auto _ : state) benchmark::DoNotOptimize(curvature_density(m.mesh));
}

/// Placing 4000 landmarks on surfaces of increasing density.
void BM_remesh(benchmark::State& state) {
  const auto m = testing::wavy_torus(points(state));
  const auto density = curvature_density(m.mesh);
  const RunContext ctx(1);
  for (auto _ : state) benchmark::DoNotOptimize(remesh(m.mesh, m.map, density, ctx));
}

/// One check of all landmarks of four shapes. Refinement takes this time if there is no defect.
void BM_refine_landmarks(benchmark::State& state) {
  const auto m = testing::wavy_torus(points(state));
  const RunContext ctx(1);
  const LandmarkMesh landmarks = remesh(m.mesh, m.map, curvature_density(m.mesh), ctx);
  const TorusLocator locator(m.mesh, m.map);
  const TriangleTree tree(m.mesh);
  const std::vector<LandmarkShape> shapes(4, {&locator, &tree});
  for (auto _ : state) benchmark::DoNotOptimize(refine_landmarks(landmarks, shapes, ctx));
}

BENCHMARK(BM_make_torus_grid)->Arg(2500)->Arg(10000)->Arg(65000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_build_locator)->Arg(2500)->Arg(10000)->Arg(50000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_locate)->Arg(2500)->Arg(10000)->Arg(50000)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_curvature_density)->Arg(10000)->Arg(65000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_remesh)->Arg(10000)->Arg(20000)->Arg(65000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_refine_landmarks)->Arg(20000)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace foramen
