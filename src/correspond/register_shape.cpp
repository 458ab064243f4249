#include "foramen/correspond/register_shape.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/parameterize/initial_map.hpp"
#include "foramen/parameterize/refine_map.hpp"
#include "foramen/simplify/working_mesh.hpp"
#include "foramen/spatial/point_index.hpp"
#include "foramen/topology/linking.hpp"

namespace foramen {
namespace {

// A first map of a working mesh in the reference's basis, unit lattice, with the matrices that justify it.
struct NamedMap {
  TorusMap map;
  Eigen::Matrix2i homology, seifert;
};

NamedMap first_map(const Mesh& aligned, const ReferenceLoops& reference, const RegisterOptions& options) {
  const LoopSystem loops = propagate_loops(aligned, reference, options.edge_cost);
  const Cocycle form = cocycle(aligned, loops);
  NamedMap named;
  named.homology = transfer_homology(aligned, form, reference).a;
  named.seifert = seifert_matrix(aligned, loops.loops[0], loops.loops[1]);
  if (!seifert_test(named.homology, named.seifert, reference.seifert))
    throw TopologyError(
        "the reference's loops were carried to loops of another class on this shape (Seifert test failed): "
        "the shape is probably misaligned or of another anatomy");
  const TorusMap unnamed = options.initial_map == InitialMap::torus ? harmonic_torus_map(aligned, form)
                                                                    : rectangle_torus_map(aligned, loops);
  named.map = change_basis(unnamed, inverse_unimodular(named.homology));
  return named;
}

// Moves the whole map so that, on average, nearest neighbours have the same torus coordinates: the
// area-weighted circular mean of their differences.
TorusMap translated_onto(TorusMap map, const Mesh& aligned, const Mesh& reference,
                         const TorusMap& reference_map) {
  const auto normals = vertex_normals(aligned), reference_normals = vertex_normals(reference);
  const OrientedPointIndex index(reference.positions(), reference_normals.values(),
                                 vertebra_normal_weight_mm);
  const auto areas = vertex_areas(aligned);
  Vec2 cosine = Vec2::Zero(), sine = Vec2::Zero();
  for (VertexId v : aligned.vertices()) {
    const VertexId near(index.nearest(aligned.position(v), normals[v]).index);
    const Vec2 difference = 2 * std::numbers::pi * (reference_map.turns[near] - map.turns[v]);
    cosine += areas[v] * difference.array().cos().matrix();
    sine += areas[v] * difference.array().sin().matrix();
  }
  const Vec2 shift =
      Vec2(std::atan2(sine.x(), cosine.x()), std::atan2(sine.y(), cosine.y())) / (2 * std::numbers::pi);
  for (Vec2& p : map.turns) p += shift;
  return map;
}

OptimiseMapOptions optimise_options(const RegisterOptions& options) {
  return {.optimiser = options.optimiser,
          .weighting = options.weighting,
          .lambda = options.lambda,
          .relative_tolerance = options.relative_tolerance,
          .iteration_limit = options.iteration_limit};
}

void require_converged(const OptimisedMap& result, const char* where) {
  if (result.status == OptimiseStatus::iteration_limit)
    throw ConvergenceError(std::string("the map of the ") + where + " mesh did not converge within " +
                           std::to_string(result.iterations) + " iterations");
}

ShapeMap certified(const Mesh& input, const OptimisedMap& working, const OptimisedMap& full) {
  ShapeMap result;
  result.map = quantised(input, wrapped(input, full.map));
  result.certificate = certify(input, result.map);
  result.iterations = working.iterations + full.iterations;
  result.initial_energy = working.initial_energy;
  result.final_energy = full.final_energy;
  result.distortion = full.distortion;
  if (!result.certificate.valid())
    throw ConvergenceError("the final map is not one to one: " + std::to_string(result.certificate.flipped) +
                           " of its triangles are flipped or have no area");
  return result;
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
  const OptimisedMap coarse =
      optimise_map(working.mesh, first_map(working.mesh, reference.loops, options).map, ctx, free_lattice);
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
  NamedMap named = first_map(working.mesh, reference.loops, options);
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
