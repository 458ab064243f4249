#include "landmarks/landmarks_by_torus.hpp"

#include <memory>
#include <utility>

#include "core/kept_results.hpp"
#include "core/parallel.hpp"
#include "correspond/registered_archive.hpp"
#include "foramen/core/error.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "sampling/curvature_density.hpp"
#include "sampling/error_density.hpp"
#include "sampling/landmark_archive.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/refine_landmarks.hpp"
#include "sampling/remesh.hpp"
#include "sampling/torus_grid.hpp"

namespace foramen {
namespace {

// The search for the number of landmarks starts with the first number and increases it until the error is
// reached.
constexpr int first_landmarks = 500, most_landmarks = 30000;
constexpr double landmark_growth = 1.4;
constexpr int search_samples = 4000;

// Data of each shape for lifting and for distances, computed once.
struct LiftingShape {
  std::unique_ptr<TorusLocator> locator;
  VertexMap<Vec2> turns;               // torus positions of the vertices
  std::unique_ptr<TriangleTree> tree;  // set by plant_trees()
};

// Replaces the maps by their locators, because both together would need too much memory for a cohort of large
// shapes.
std::vector<LiftingShape> lifting_shapes(const std::vector<Mesh>& meshes, std::vector<TorusMap> maps,
                                         const RunContext& ctx) {
  std::vector<LiftingShape> shapes(meshes.size());
  parallel_for(static_cast<int>(shapes.size()), ctx, [&](int i) {
    const std::size_t k = i;
    TorusMap map = std::exchange(maps[k], {});
    shapes[k].locator = std::make_unique<TorusLocator>(meshes[k], map);
    shapes[k].turns = std::move(map.turns);
  });
  return shapes;
}

void plant_trees(std::vector<LiftingShape>& shapes, const RunContext& ctx) {
  parallel_for(static_cast<int>(shapes.size()), ctx, [&](int i) {
    LiftingShape& shape = shapes[i];
    shape.tree = std::make_unique<TriangleTree>(shape.locator->mesh(), TreeNormals::none);
  });
}

std::vector<std::vector<Vec3>> lifted_to_all(const std::vector<LiftingShape>& shapes,
                                             std::span<const Vec2> turns, const RunContext& ctx) {
  std::vector<std::vector<Vec3>> all(shapes.size());
  parallel_for(static_cast<int>(shapes.size()), ctx,
               [&](int i) { all[i] = lift_to_surface(*shapes[i].locator, turns); });
  return all;
}
// The dense mean, on which landmarks are placed, with its torus map and the density of landmarks.
struct DenseMean {
  TorusGrid grid;
  Mesh mesh;
  TorusMap map;
  VertexMap<double> density;
};

DenseMean dense_mean(const std::vector<LiftingShape>& shapes, const Lattice& lattice,
                     const PlaceLandmarksOptions& options, const RunContext& ctx) {
  DenseMean mean;
  mean.grid = make_torus_grid(lattice, options.spread.grid_points);
  const TorusGrid& grid = mean.grid;
  mean.mesh =
      build_mesh({procrustes(lifted_to_all(shapes, grid.turns, ctx), options.scale).mean, grid.triangles});
  mean.map = {lattice, VertexMap<Vec2>(grid.turns), grid.jumps};
  mean.density = curvature_density(mean.mesh, options.spread.density);
  return mean;
}

// The density for the next landmarks, raised where the present ones represent a shape badly.
VertexMap<double> density_after(const LandmarkMesh& landmarks, const VertexMap<double>& density,
                                const DenseMean& mean, const std::vector<LiftingShape>& shapes,
                                const PlaceLandmarksOptions& options, const RunContext& ctx) {
  auto lifted = lifted_to_all(shapes, landmarks.turns, ctx);
  std::vector<RepresentedShape> represented;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    represented.push_back({&shapes[i].locator->mesh(), &shapes[i].turns, std::move(lifted[i])});
  return raised_by_error(density, mean.grid, represented, landmarks.triangles, ctx, options.spread.errors);
}

RefinedLandmarks landmarks_on(const DenseMean& mean, const std::vector<LiftingShape>& shapes, int count,
                              const PlaceLandmarksOptions& options, const RunContext& ctx) {
  const RemeshOptions remeshing{.landmarks = count, .relaxation_rounds = options.spread.relaxation_rounds};
  VertexMap<double> density = mean.density;
  LandmarkMesh landmarks = remesh(mean.mesh, mean.map, density, ctx, remeshing);
  for (int k = 0; k < options.spread.density_updates; ++k) {
    density = density_after(landmarks, density, mean, shapes, options, ctx);
    landmarks = remesh(mean.mesh, mean.map, density, ctx, remeshing);
  }
  std::vector<LandmarkShape> views;
  for (const LiftingShape& shape : shapes) views.push_back({shape.locator.get(), shape.tree.get()});
  return refine_landmarks(landmarks, views, ctx);
}

double mean_representation_error(const LandmarkMesh& landmarks, const std::vector<LiftingShape>& shapes,
                                 const PlaceLandmarksOptions& options, const RunContext& ctx) {
  std::vector<double> errors(shapes.size());
  parallel_for(static_cast<int>(shapes.size()), ctx, [&](int i) {
    const LiftingShape& shape = shapes[i];
    const TriangleTree sampled(
        build_mesh({lift_to_surface(*shape.locator, landmarks.turns), landmarks.triangles}));
    errors[i] =
        surface_distance(sampled, *shape.tree, {.samples = search_samples, .seed = options.seed}).mean;
  });
  double sum = 0;
  for (double error : errors) sum += error;
  return sum / static_cast<double>(errors.size());
}

// The smallest tried number of landmarks that reaches the error.
RefinedLandmarks landmarks_for_error(const DenseMean& mean, const std::vector<LiftingShape>& shapes,
                                     const PlaceLandmarksOptions& options, const RunContext& ctx) {
  for (int count = first_landmarks; count <= most_landmarks;
       count = static_cast<int>(landmark_growth * count)) {
    ctx.check();
    RefinedLandmarks refined = landmarks_on(mean, shapes, count, options, ctx);
    if (mean_representation_error(refined.landmarks, shapes, options, ctx) <= *options.target_error_mm)
      return refined;
  }
  throw ConvergenceError("the target error of " + std::to_string(*options.target_error_mm) +
                         " mm is not reached with " + std::to_string(most_landmarks) +
                         " landmarks; give a larger one");
}

// The digest of each shape by itself: the bytes of all of them at once may be too many to hold.
StageKey key_of_landmarks(const std::vector<Mesh>& meshes, const std::vector<TorusMap>& maps,
                          const PlaceLandmarksOptions& options, const RunContext& ctx) {
  std::vector<StageKey> mapped;
  for (std::size_t i = 0; i < meshes.size(); ++i)
    mapped.emplace_back(ctx, "mapped shape", meshes[i], maps[i]);
  return {ctx, "landmarks", mapped, options};
}

}  // namespace

Landmarks landmarks_by_torus(const std::vector<Mesh>& meshes, std::vector<TorusMap> maps,
                             const PlaceLandmarksOptions& options, const RunContext& ctx) {
  const StageKey key = key_of_landmarks(meshes, maps, options, ctx);
  const Lattice lattice = maps.front().lattice;
  std::vector<LiftingShape> shapes = lifting_shapes(meshes, std::move(maps), ctx);
  RefinedLandmarks refined = kept<RefinedLandmarks>(ctx, key, [&] {
    const DenseMean mean = dense_mean(shapes, lattice, options, ctx);
    plant_trees(shapes, ctx);
    ctx.step("resample", 0.3);
    return options.target_error_mm ? landmarks_for_error(mean, shapes, options, ctx)
                                   : landmarks_on(mean, shapes, options.count, options, ctx);
  });
  ctx.step("resample", 0.9);
  Landmarks result;
  result.points = lifted_to_all(shapes, refined.landmarks.turns, ctx);
  result.mesh = std::move(refined.landmarks);
  result.inserted = refined.inserted;
  result.remaining_flips = refined.remaining;
  result.initial_self_intersections = refined.initial_self_intersections;
  result.remaining_self_intersections = refined.remaining_self_intersections;
  return result;
}

}  // namespace foramen
