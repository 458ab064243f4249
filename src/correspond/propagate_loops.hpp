#pragma once
/// \file
/// The reference's basepoint and loops carried to an aligned shape, the paper's way.

#include "foramen/core/options.hpp"
#include "foramen/correspond/register_options.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

/// The shortest loops of a genus-1 surface over all basepoints, oriented, with their Seifert matrix.
ReferenceLoops find_reference_loops(const Mesh& mesh, const RunContext& ctx);

/// The cost of every edge of an aligned shape. [becker2011 Eq. 3]
EdgeMap<double> loop_edge_costs(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost);

/// Basepoint: the vertex of the shape nearest to the reference's; loops: the greedy system from it by the
/// edge costs, oriented. Not named: loop k need not be the reference's loop k, see transfer_homology().
LoopSystem propagate_loops(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost);

/// The same system with its second loop reversed if the two cross the other way, so that a torus map with
/// their periods has positive area. \pre genus 1
LoopSystem oriented(const Mesh& mesh, LoopSystem loops);

}  // namespace foramen
