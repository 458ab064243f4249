#include "evaluate/pruned_distance.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "evaluate/closest_shape.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "support/torus_cohort.hpp"

namespace foramen::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int samples = 300;
constexpr std::uint64_t seed = 5;

std::vector<Mesh> aligned_inputs(const testing::TorusCohortOptions& options = {}) {
  return align_cohort(testing::torus_cohort(options), ScaleMode::keep).inputs;
}

SurfaceDistance oracle(const Mesh& a, const Mesh& b) {
  return surface_distance(TriangleTree(a), TriangleTree(b), {.samples = samples, .seed = seed});
}

TEST(MeasuredSurface, ClustersHoldEveryPointOnce) {
  const Mesh mesh = aligned_inputs()[0];
  MeasuredSurface surface(mesh, samples, seed);
  for (const double stretch : {1.0, 1.7}) {  // before and after a motion
    std::vector<Vec3> expected, found;
    for (const Vec3& p : mesh.positions()) expected.push_back(Vec3(stretch, 1, 1 / stretch).cwiseProduct(p));
    surface.move_to(expected);
    const Mesh moved = mesh.with_positions(expected);
    for (const SurfacePoint& s : sample_surface(moved, samples, Rng(seed)))
      expected.push_back(position(moved, s));
    for (const PointCluster& c : surface.clusters())
      for (const Vec3& p : surface.points(c)) {
        EXPECT_LE((p - c.centre).norm(), c.radius * (1 + 1e-12));
        found.push_back(p);
      }
    const auto before = [](const Vec3& a, const Vec3& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    };
    std::sort(expected.begin(), expected.end(), before);
    std::sort(found.begin(), found.end(), before);
    EXPECT_EQ(found, expected);
  }
}

TEST(HausdorffDistance, IsThatOfSurfaceDistanceToTheBit) {
  const auto meshes = aligned_inputs();
  std::vector<MeasuredSurface> surfaces;
  for (const Mesh& m : meshes) surfaces.emplace_back(m, samples, seed);
  for (std::size_t i = 0; i < meshes.size(); ++i)
    for (std::size_t j = 0; j < meshes.size(); ++j) {
      FarthestClusters start;
      const double first = hausdorff_distance(surfaces[i], surfaces[j], infinity, start);
      EXPECT_EQ(first, oracle(meshes[i], meshes[j]).hausdorff);
      EXPECT_EQ(hausdorff_distance(surfaces[i], surfaces[j], infinity, start), first);  // with a better start
      EXPECT_EQ(hausdorff_distance(surfaces[i], surfaces[j], first, start), first);
      if (i != j) {
        EXPECT_GT(hausdorff_distance(surfaces[i], surfaces[j], 0.9 * first, start), 0.9 * first);
      }
    }
}

TEST(SampleDistances, GiveTheMeanOfSurfaceDistanceToTheBit) {
  const auto meshes = aligned_inputs();
  const MeasuredSurface a(meshes[0], samples, seed), b(meshes[1], samples, seed);
  EXPECT_EQ(0.5 * (mean_of(sample_distances(a, b)) + mean_of(sample_distances(b, a))),
            oracle(meshes[0], meshes[1]).mean);
}

TEST(DistanceLattice, BoundsAreBelowAndClose) {
  const auto meshes = aligned_inputs();
  std::vector<MeasuredSurface> surfaces;
  for (const Mesh& m : meshes) surfaces.emplace_back(m, samples, seed);
  constexpr double reach = 6, spacing = 2;
  const DistanceLattice lattice(surfaces[0], surfaces, reach, spacing, RunContext(1));
  std::vector<float> bounds(lattice.width());
  Rng rng(3);
  int reached = 0;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 p = 45 * Vec3(rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-0.5, 0.5));
    const double to_middle = std::sqrt(surfaces[0].tree().squared_distance(p));
    if (!lattice.lower_bounds(p, bounds)) {
      EXPECT_GT(to_middle, reach - 2 * spacing);  // a corner of the cell is out of reach
      continue;
    }
    ++reached;
    for (std::size_t s = 0; s < surfaces.size(); ++s) {
      const double d = std::sqrt(surfaces[s].tree().squared_distance(p));
      EXPECT_LE(static_cast<double>(bounds[s]), d);
      // Convexity alone loses at most 3 h^2 / 4 of the square, more only where the closest point jumps.
      if (d > spacing && to_middle < 3) {
        EXPECT_GT(static_cast<double>(bounds[s]), 0.5 * d - 1);
      }
      EXPECT_FALSE(lattice.surely_within(s, p, d * (1 - 1e-9)));
      if (to_middle < 3) {
        EXPECT_TRUE(lattice.surely_within(s, p, d + 2 * spacing));
      }
    }
  }
  EXPECT_GT(reached, 500);
}

TEST(ClosestShapeSearch, FindsWhatComparingAllFinds) {
  const auto meshes = aligned_inputs({.shapes = 7});
  const std::vector<Mesh> training(meshes.begin() + 2, meshes.end());
  for (const double spacing : {1.5, 8.0})
    for (const double reach : {0.5, 6.0}) {
      const TrainingSurfaces surfaces(MeasuredSurface(meshes[0], samples, seed), training, samples, seed,
                                      reach, spacing, RunContext(1));
      ClosestShapeSearch search(surfaces);
      MeasuredSurface probe(meshes[0], samples, seed);
      for (const double t : {0.0, 0.2, 0.4, 1.0, 0.9}) {  // from one shape to another, and back a little
        std::vector<Vec3> between;
        for (std::size_t v = 0; v < meshes[0].positions().size(); ++v)
          between.push_back((1 - t) * meshes[0].positions()[v] + t * meshes[1].positions()[v]);
        const Mesh mesh = meshes[0].with_positions(between);
        double hausdorff = infinity, mean = infinity;
        for (const Mesh& other : training) {
          const SurfaceDistance d = oracle(mesh, other);
          hausdorff = std::min(hausdorff, d.hausdorff);
          mean = std::min(mean, d.mean);
        }
        probe.move_to(between);
        search.look_at(probe);
        EXPECT_EQ(search.smallest_mean(), mean);
        EXPECT_EQ(search.smallest_hausdorff([](std::size_t) { return 0.0; }, [](std::size_t, double) {}),
                  hausdorff);
        std::vector<double> all(training.size(), 0);  // if all shapes are requested, all are found
        search.smallest_hausdorff([](std::size_t) { return infinity; },
                                  [&](std::size_t i, double d) { all[i] = d; });
        for (std::size_t i = 0; i < training.size(); ++i)
          EXPECT_EQ(all[i], oracle(mesh, training[i]).hausdorff);
      }
    }
}

}  // namespace
}  // namespace foramen::detail
