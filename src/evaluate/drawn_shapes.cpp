#include "foramen/evaluate/drawn_shapes.hpp"

#include <cmath>
#include <string>

#include "core/parallel.hpp"
#include "evaluate/stage_progress.hpp"
#include "foramen/core/error.hpp"
#include "spatial/flips.hpp"
#include "spatial/self_intersections.hpp"

namespace foramen {
namespace {

Eigen::VectorXd truncated_scores(const ShapeModel& model, Rng rng) {
  Eigen::VectorXd b(model.modes());
  for (Eigen::Index m = 0; m < b.size(); ++m) {
    double sd = rng.normal();
    while (std::abs(sd) > largest_drawn_sd) sd = rng.normal();
    b[m] = std::sqrt(model.variance()[m]) * sd;
  }
  return b;
}

/// \param of_mean  the surface of the mean; a copy of it is refitted for every draw, which is faster than a
/// new tree
DrawnShape measure(const TriangleTree& of_mean, const Eigen::VectorXd& landmarks) {
  const Mesh& mean = of_mean.mesh();
  TriangleTree surface = of_mean;
  surface.refit(mean.with_positions(unflattened(landmarks)));
  return {.self_intersections = static_cast<int>(self_intersections(surface).size()),
          .folded = folded_over(surface.mesh(), mean),
          .opposing_mean = opposing_mean(surface.mesh(), mean)};
}

Estimate share(const std::vector<DrawnShape>& draws, int DrawnShape::*count) {
  std::vector<double> any;
  any.reserve(draws.size());
  for (const DrawnShape& d : draws) any.push_back(d.*count > 0 ? 1 : 0);
  return estimate(any);
}

}  // namespace

DrawnShapes drawn_shapes(const ShapeModel& model, const DrawnShapesOptions& options, const RunContext& ctx) {
  if (options.draws <= 0)
    throw InvalidInput("drawn shapes: " + std::to_string(options.draws) + " draws asked for; give 1 or more");
  const TriangleTree of_mean(build_mesh({unflattened(model.mean()), model.triangles()}));
  const Rng root(options.seed);
  DrawnShapes result;
  result.draws.resize(options.draws);
  detail::StageProgress progress(ctx, "drawn shapes", options.draws);
  parallel_for(options.draws, ctx, [&](int i) {
    const Eigen::VectorXd b = truncated_scores(model, root.fork(static_cast<std::uint64_t>(i)));
    result.draws[i] = measure(of_mean, model.reconstruct(b));
    progress.finished_one();
  });
  result.self_intersecting = share(result.draws, &DrawnShape::self_intersections);
  result.folded = share(result.draws, &DrawnShape::folded);
  result.opposing_mean = share(result.draws, &DrawnShape::opposing_mean);
  return result;
}

}  // namespace foramen
