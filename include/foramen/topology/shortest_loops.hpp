#pragma once
/// \file
/// Shortest systems of loops on a closed surface of genus g \cite erickson2005: 2g loops with a common
/// basepoint that cut the surface into one disk.

#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

/// A closed walk along edges: to(h[k]) == from(h[k+1]), and the last ends where the first begins.
using EdgeLoop = std::vector<HalfedgeId>;

/// Sum of the weights of the edges of the walk.
double loop_length(const Mesh& mesh, const EdgeLoop& loop, const EdgeMap<double>& weights);

/// A system of loops and the tree-cotree decomposition from which it is made.
struct LoopSystem {
  VertexId basepoint;
  std::vector<EdgeLoop> loops;  ///< 2g, each from the basepoint to the basepoint
  /// The edge of each loop that is in neither tree, in the direction of the loop.
  std::vector<HalfedgeId> generators;
  /// Halfedge from the parent in the shortest-path tree; invalid at the root.
  VertexMap<HalfedgeId> tree_parent;
  double length = 0;  ///< sum over loops, in units of the weights
};

/// The shortest system of loops with this basepoint \cite erickson2005, Section 3. T is the tree of shortest
/// paths from the basepoint. C* is the maximum spanning tree of the dual graph of the edges not in T,
/// weighted by the length of the loop that an edge closes with T. The 2g edges in neither tree are the
/// generators of the loops.
///
/// Loops are in order of length, shortest first. Each loop traverses its generator from the end with the
/// lexicographically smaller position. Ties are broken by position (by index only if positions are equal or
/// weights are zero), so the loops do not depend on the numbering of the mesh. The run time is nearly linear.
/// Throws TopologyError if the mesh is not closed or not connected, InvalidInput for a weight that is
/// negative or not finite.
LoopSystem greedy_loops(const Mesh& mesh, VertexId basepoint, const EdgeMap<double>& weights);

struct ShortestLoopsOptions {
  int evaluation_limit = 0;  ///< Stops with ConvergenceError after this many basepoints; 0: no limit.
};
/// The result of shortest_loops().
struct ShortestLoopsResult {
  LoopSystem system;
  int evaluations = 0;  ///< basepoints whose loops were computed
};
/// The shortest system of loops over all basepoints, exactly. It is found by best-first branch and bound with
/// the bounds l_k(b') >= l_k(b) - 2 d(b, b') for the length l_k of the k-th shortest loop and the distance d
/// of two basepoints. Of basepoints with equally short systems (relative 1e-12) the one of lexicographically
/// smallest position is taken, so the result does not depend on the numbering of the mesh. Throws what
/// greedy_loops() throws, TopologyError for a sphere, and ConvergenceError at options.evaluation_limit.
ShortestLoopsResult shortest_loops(const Mesh& mesh, const EdgeMap<double>& lengths, const RunContext& ctx,
                                   const ShortestLoopsOptions& options = {});

/// The shortest loop that is not homologous to zero. Cutting along it leaves the surface connected. It visits
/// no vertex twice. Search, ties and errors are those of shortest_loops(), but the length of the first loop
/// is minimised instead of the length of the system.
EdgeLoop shortest_loop(const Mesh& mesh, const EdgeMap<double>& lengths, const RunContext& ctx,
                       const ShortestLoopsOptions& options = {});

/// Shortest paths from one source: for each vertex its distance and the last halfedge of the path (invalid at
/// the source).
struct ShortestPaths {
  VertexMap<double> distance;
  VertexMap<HalfedgeId> parent;
};
ShortestPaths shortest_paths(const Mesh& mesh, VertexId source, const EdgeMap<double>& weights);
/// The shortest path from the source to v, as a walk along halfedges.
std::vector<HalfedgeId> path_to(const Mesh& mesh, const ShortestPaths& paths, VertexId v);

}  // namespace foramen
