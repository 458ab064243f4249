#pragma once
/// \file
/// Transfer of the reference's basepoint and loops to an aligned shape, as in the paper.

#include "foramen/core/options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

/// The shortest loops of a genus-1 surface over all basepoints, oriented, with their Seifert matrix.
ReferenceLoops find_reference_loops(const Mesh& mesh, const RunContext& ctx);

/// The cost of every edge of an aligned shape. [becker2011 Eq. 3]
EdgeMap<double> loop_edge_costs(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost);

/// Transfers the loops: the basepoint is the vertex of the shape nearest to the reference's basepoint, and
/// the loops are the oriented greedy system from it with the edge costs as weights. Loop k need not
/// correspond to loop k of the reference, see transfer_homology().
LoopSystem propagate_loops(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost);

/// The same system, with the second loop reversed if necessary so that a torus map with their periods has
/// positive area. \pre genus 1
LoopSystem oriented(const Mesh& mesh, LoopSystem loops);

}  // namespace foramen
