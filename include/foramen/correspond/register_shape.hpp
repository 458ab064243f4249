#pragma once
/// \file
/// The torus map of the reference, and of every other shape in correspondence with it.

#include "foramen/core/options.hpp"
#include "foramen/correspond/first_map.hpp"
#include "foramen/correspond/shape_map.hpp"
#include "foramen/correspond/soft_neighbours.hpp"
#include "foramen/match/align.hpp"

namespace foramen {

struct RegisterOptions {
  InitialMap initial_map = InitialMap::torus;
  Optimiser optimiser = Optimiser::newton;
  Weighting weighting = Weighting::area;
  EdgeCost edge_cost = EdgeCost::length_weighted;
  SoftNeighboursOptions neighbours = {};
  double lambda = 0.05;
  int working_vertices = 10000;
  double relative_tolerance = 1e-4;
  int iteration_limit = 200;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<RegisterOptions> auto& o) {
  visit(o.lambda,
        {.name = "lambda", .range = above(0), .meaning = "weight of distortion against correspondence"});
  visit(o.weighting,
        {.name = "weighting", .meaning = "whether terms are weighted by their area or counted each"});
  visit(o.initial_map, {.name = "initial_map", .meaning = "first map of a shape"});
  visit(o.optimiser, {.name = "optimiser", .meaning = "projected Newton, or the paper's node-wise descent"});
  visit(o.edge_cost, {.name = "edge_cost", .meaning = "cost of an edge when loops are carried to a shape"});
  visit(o.neighbours, {.nesting = Nesting::inlined});
  visit(o.working_vertices, {.name = "working_vertices",
                             .range = at_least(16),
                             .meaning = "vertices of the simplified mesh that carries the search"});
  visit(o.relative_tolerance, {.name = "relative_tolerance",
                               .range = above(0),
                               .meaning = "relative decrease of the energy at which an optimisation stops"});
  visit(o.iteration_limit,
        {.name = "iteration_limit", .range = at_least(1), .meaning = "most iterations of an optimisation"});
}

/// The paper's own choices: eq. 3 as printed, rectangle, node-wise Polak-Ribiere, eq. 4 with plain
/// neighbours, lambda = 0.00025.
RegisterOptions paper_options();

struct Reference {
  ReferenceLoops loops;  ///< with the mesh
  ShapeMap shape_map;
  const Mesh& mesh() const { return loops.mesh; }
};

/// Finds the shortest loops of the reference over all basepoints, computes its first map, and minimises the
/// distortion with the lattice free. The lattice that is found is that of all shapes.
Reference map_reference(const Mesh& mesh, const RunContext& ctx, const RegisterOptions& options = {});

struct RegisteredShape {
  Alignment alignment;  ///< shape -> reference
  ShapeMap shape_map;
  Eigen::Matrix2i homology = Eigen::Matrix2i::Zero();  ///< A, see transfer_homology()
  Eigen::Matrix2i seifert = Eigen::Matrix2i::Zero();   ///< of the shape's own loops
  Vec2 agreement = Vec2::Zero();                       ///< see map_agreement()
};

/// Aligns the shape with the reference, carries the reference's loops to it, maps it to the reference's torus
/// and minimises E_cor + lambda E_deg. Throws TopologyError or ConvergenceError with the reason if a check
/// fails: the Seifert test of the first map, the certificate of the finished map, its homology or its
/// direction.
RegisteredShape register_shape(const Mesh& shape, const Reference& reference, const RunContext& ctx,
                               const RegisterOptions& options = {});

}  // namespace foramen
