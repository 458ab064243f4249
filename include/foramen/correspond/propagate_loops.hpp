#pragma once
/// \file
/// The reference's basepoint and loops carried to an aligned shape, the paper's way.

#include "foramen/core/options.hpp"
#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

/// The reference's loops as every other shape sees them.
struct ReferenceLoops {
  Mesh mesh;                ///< the reference, in its own coordinates
  LoopSystem loops;         ///< two, oriented so that the torus map they give has positive area
  Eigen::Matrix2i seifert;  ///< see seifert_matrix()
};

/// The shortest loops of a genus-1 surface over all basepoints, oriented, with their Seifert matrix.
ReferenceLoops find_reference_loops(const Mesh& mesh, const RunContext& ctx);

enum class EdgeCost {
  paper,  ///< [becker2011 Eq. 3] as printed: mean distance of the two ends to the reference loops [mm];
          ///< counts hops
  length_weighted,  ///< (that + 0.5 mm) * edge length [mm^2]: independent of how finely the surface is meshed
};
template <>
struct EnumWords<EdgeCost> {
  static constexpr std::pair<std::string_view, EdgeCost> all[] = {
      {"paper", EdgeCost::paper}, {"length_weighted", EdgeCost::length_weighted}};
};

/// The cost of every edge of an aligned shape. [becker2011 Eq. 3]
EdgeMap<double> loop_edge_costs(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost);

/// Basepoint: the vertex of the shape nearest to the reference's; loops: the greedy system from it by the
/// edge costs, oriented. Not named: loop k need not be the reference's loop k, see transfer_homology().
LoopSystem propagate_loops(const Mesh& aligned_shape, const ReferenceLoops& reference, EdgeCost cost);

/// The same system with its second loop reversed if the two cross the other way, so that a torus map with
/// their periods has positive area. \pre genus 1
LoopSystem oriented(const Mesh& mesh, LoopSystem loops);

}  // namespace foramen
