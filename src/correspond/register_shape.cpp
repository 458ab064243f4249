#include "foramen/correspond/register_shape.hpp"

#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/refine_map.hpp"
#include "foramen/simplify/working_mesh.hpp"

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
  options.iteration_limit = 5000;  // sweeps over all nodes, each far cheaper than a Newton iteration
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
  require_converged(coarse, "working");
  const OptimisedMap full =
      optimise_map(mesh, refine_map(mesh, working, coarse.map), ctx, optimise_options(options));
  require_converged(full, "input");
  reference.shape_map = certified(mesh, coarse, full);
  return reference;
}

RegisteredShape register_shape(const Mesh& shape, const Reference& reference, const RunContext& ctx,
                               const RegisterOptions& options) {
  RegisteredShape result;
  result.alignment = align(shape, reference.mesh(), ctx);
  const Mesh aligned = transformed(shape, result.alignment.transform);
  const TorusMap& reference_map = reference.shape_map.map;

  const WorkingMesh working = simplify(aligned, ctx, {.target_vertices = options.working_vertices});
  FirstMap named =
      first_map(working.mesh, working.mesh, reference.loops, options.initial_map, options.edge_cost);
  result.homology = named.homology;
  result.seifert = named.seifert;
  named.map.lattice = reference_map.lattice;
  const TorusMap start = translated_onto(std::move(named.map), working.mesh, reference.mesh(), reference_map);

  const SoftNeighbours pull(working.mesh, reference.mesh(), reference_map, options.neighbours);
  const OptimisedMap coarse = optimise_map(working.mesh, start, ctx, optimise_options(options), &pull);
  require_converged(coarse, "working");
  const SoftNeighbours full_pull(aligned, reference.mesh(), reference_map, options.neighbours);
  const OptimisedMap full = optimise_map(aligned, refine_map(aligned, working, coarse.map), ctx,
                                         optimise_options(options), &full_pull);
  require_converged(full, "input");
  result.shape_map = certified(aligned, coarse, full);

  result.agreement = map_agreement(aligned, result.shape_map.map, reference.mesh(), reference_map);
  if (result.agreement.minCoeff() <= 0)
    throw TopologyError(
        "the map of this shape runs against the reference's (the loops' directions disagree)");
  return result;
}

}  // namespace foramen
