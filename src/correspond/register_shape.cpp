#include "correspond/register_shape.hpp"

#include "correspond/map_steps.hpp"
#include "correspond/propagate_loops.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {
namespace {

OptimiseMapOptions optimise_options(const RegisterOptions& options) {
  return {.optimiser = options.optimiser,
          .weighting = options.weighting,
          .lambda = options.lambda,
          .relative_tolerance = options.relative_tolerance,
          .iteration_limit = options.iteration_limit};
}

}  // namespace

RegisterOptions paper_options() {
  RegisterOptions options;
  options.initial_map = InitialMap::rectangle;
  options.optimiser = Optimiser::polak_ribiere;
  options.weighting = Weighting::each;
  options.edge_cost = EdgeCost::paper;
  options.neighbours.search = NeighbourSearch::points;
  options.neighbours.weights = NeighbourWeights::absolute;
  options.lambda = 0.00025;
  options.iteration_limit = 5000;  // sweeps over all nodes, which are much cheaper than Newton iterations
  return options;
}

Reference map_reference(const Mesh& mesh, const RunContext& ctx, const RegisterOptions& options) {
  Reference reference{find_reference_loops(mesh, ctx), {}};
  const WorkingMesh working = simplify(mesh, ctx, {.target_vertices = options.working_vertices});
  OptimiseMapOptions free_lattice = optimise_options(options);
  free_lattice.free_lattice =
      options.optimiser == Optimiser::newton;  // node-wise descent keeps the unit square
  const OptimisedMap coarse = optimise_map(
      working.mesh,
      first_map(working.mesh, working.mesh, reference.loops, options.initial_map, options.edge_cost).map, ctx,
      free_lattice);
  reference.shape_map = finished_map(mesh, working, coarse, [&](const TorusMap& start) {
    return optimise_map(mesh, start, ctx, optimise_options(options));
  });
  return reference;
}

RegisteredShape register_shape(const Mesh& shape, const Reference& reference, const RunContext& ctx,
                               const RegisterOptions& options) {
  RegisteredShape result;
  result.alignment = align(shape, reference.mesh(), ctx);
  const Mesh aligned = transformed(shape, result.alignment.transform);
  const WorkingMesh working = simplify(aligned, ctx, {.target_vertices = options.working_vertices});
  const FirstMap first =
      placed_first_map(working.mesh, working.mesh, reference, options.initial_map, options.edge_cost);
  result.homology = first.homology;
  result.seifert = first.seifert;

  const auto optimised = [&](const Mesh& mesh, const TorusMap& start) {
    const SoftNeighbours pull(mesh, reference.mesh(), reference.shape_map.map, options.neighbours);
    return optimise_map(mesh, start, ctx, optimise_options(options), &pull);
  };
  const OptimisedMap coarse = optimised(working.mesh, first.map);
  result.shape_map = finished_map(aligned, working, coarse,
                                  [&](const TorusMap& start) { return optimised(aligned, start); });
  result.agreement =
      require_map_like_reference(shape, result.alignment.transform, result.shape_map.map, reference);
  return result;
}

}  // namespace foramen
