// Queries of the spatial module on a real vertebra (42 556 triangles), or on a torus of that size if there is
// no real data.

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

#include "foramen/core/geometry.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "spatial/flips.hpp"
#include "spatial/point_index.hpp"
#include "spatial/self_intersections.hpp"
#include "support/meshes.hpp"
#include "support/real_meshes.hpp"

namespace foramen {
namespace {

Mesh torus_of(int vertices) {
  const int tube = static_cast<int>(std::sqrt(vertices / 2.0));
  return build_mesh(testing::torus_soup(2 * tube, tube));
}

const Mesh& vertebra() {
  static const Mesh mesh = std::filesystem::is_directory(testing::data_dir() / "lumbar")
                               ? testing::real_mesh("lumbar/verse005_L2")
                               : torus_of(21278);
  return mesh;
}

struct Queries {
  std::vector<Vec3> points, normals;
};

// Points of the surface, in random order, moved off it by up to `offset` mm along the normal.
Queries around(const Mesh& mesh, double offset) {
  Queries q;
  Rng rng(3);
  for (const SurfacePoint& p : sample_surface(mesh, 4096, rng)) {
    q.normals.push_back(unit_normal(mesh.triangle(p.face)));
    q.points.push_back(position(mesh, p) + rng.uniform(-offset, offset) * q.normals.back());
  }
  for (std::size_t i = q.points.size(); i > 1; --i) {
    const std::size_t j = rng.below(static_cast<int>(i));
    std::swap(q.points[i - 1], q.points[j]);
    std::swap(q.normals[i - 1], q.normals[j]);
  }
  return q;
}

template <class Query>
void run_queries(benchmark::State& state, double offset, const Query& query) {
  const Queries q = around(vertebra(), offset);
  std::size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(query(q.points[i], q.normals[i]));
    i = (i + 1) % q.points.size();
  }
}

void tree_build(benchmark::State& state) {
  const Mesh mesh = torus_of(static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(TriangleTree(mesh));
  state.SetComplexityN(state.range(0));
}
BENCHMARK(tree_build)->RangeMultiplier(2)->Range(2500, 50000)->Unit(benchmark::kMillisecond)->Complexity();

void tree_build_vertebra(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(TriangleTree(vertebra()));
}
BENCHMARK(tree_build_vertebra)->Unit(benchmark::kMillisecond);

void tree_refit_vertebra(benchmark::State& state) {
  TriangleTree tree(vertebra());
  for (auto _ : state) tree.refit(vertebra());
}
BENCHMARK(tree_refit_vertebra)->Unit(benchmark::kMillisecond);

void closest(benchmark::State& state) {
  const TriangleTree tree(vertebra());
  run_queries(state, static_cast<double>(state.range(0)),
              [&](const Vec3& p, const Vec3&) { return tree.closest(p).squared_distance; });
}
BENCHMARK(closest)->Arg(0)->Arg(1)->Arg(3)->Arg(10);

void closest_compatible(benchmark::State& state) {
  const TriangleTree tree(vertebra());
  run_queries(state, static_cast<double>(state.range(0)),
              [&](const Vec3& p, const Vec3& n) { return tree.closest_compatible(p, n)->squared_distance; });
}
BENCHMARK(closest_compatible)->Arg(0)->Arg(1)->Arg(3)->Arg(10);

void any_within(benchmark::State& state) {
  const TriangleTree tree(vertebra());
  run_queries(state, 1, [&](const Vec3& p, const Vec3&) { return tree.any_within(p, 4.0); });
}
BENCHMARK(any_within);

void faces_within(benchmark::State& state) {
  const TriangleTree tree(vertebra());
  run_queries(state, 1, [&](const Vec3& p, const Vec3&) { return tree.faces_within(p, 2.0).size(); });
}
BENCHMARK(faces_within);

void nearest_point(benchmark::State& state) {
  const PointIndex index(vertebra().positions());
  run_queries(state, static_cast<double>(state.range(0)),
              [&](const Vec3& p, const Vec3&) { return index.nearest(p).index; });
}
BENCHMARK(nearest_point)->Arg(0)->Arg(3);

void nearest_8_points(benchmark::State& state) {
  const PointIndex index(vertebra().positions());
  run_queries(state, 3, [&](const Vec3& p, const Vec3&) { return index.nearest(p, 8).size(); });
}
BENCHMARK(nearest_8_points);

void nearest_oriented_point(benchmark::State& state) {
  const OrientedPointIndex index(vertebra().positions(), vertex_normals(vertebra()).values(), 8.0);
  run_queries(state, static_cast<double>(state.range(0)),
              [&](const Vec3& p, const Vec3& n) { return index.nearest(p, n).index; });
}
BENCHMARK(nearest_oriented_point)->Arg(0)->Arg(3);

Mesh shifted(const Mesh& mesh) {
  return transformed(mesh, RigidTransform(Eigen::Translation3d(1.0, 0.5, 0.3)));
}

void surface_distance_both_ways(benchmark::State& state) {
  const TriangleTree a(vertebra()), b(shifted(vertebra()));
  SurfaceDistanceOptions options;
  options.samples = static_cast<int>(state.range(0));
  for (auto _ : state) benchmark::DoNotOptimize(surface_distance(a, b, options));
}
BENCHMARK(surface_distance_both_ways)->Arg(2000)->Arg(20000)->Unit(benchmark::kMillisecond);

void flips_of_a_mesh(benchmark::State& state) {
  const TriangleTree input(vertebra());
  const Mesh moved = shifted(vertebra());
  for (auto _ : state) benchmark::DoNotOptimize(sampled_flips(moved, input).plain.size());
}
BENCHMARK(flips_of_a_mesh)->Unit(benchmark::kMillisecond);

void self_intersections_of_a_torus(benchmark::State& state) {
  const TriangleTree tree(torus_of(static_cast<int>(state.range(0))));
  for (auto _ : state) benchmark::DoNotOptimize(self_intersections(tree).size());
}
BENCHMARK(self_intersections_of_a_torus)->Arg(4000)->Arg(50000)->Unit(benchmark::kMillisecond);

void self_intersections_of_a_vertebra(benchmark::State& state) {
  const TriangleTree tree(vertebra());
  for (auto _ : state) benchmark::DoNotOptimize(self_intersections(tree).size());
}
BENCHMARK(self_intersections_of_a_vertebra)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace foramen
