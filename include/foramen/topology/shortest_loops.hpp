#pragma once
/// \file
/// Shortest systems of loops on a closed surface (Erickson and Whittlesey 2005): 2g loops with a common
/// basepoint that cut the surface open to one disk.

#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

/// A closed walk along edges: to(h[k]) == from(h[k+1]), and the last ends where the first begins.
using EdgeLoop = std::vector<HalfedgeId>;

/// Sum of the weights of the edges walked over.
double loop_length(const Mesh& mesh, const EdgeLoop& loop, const EdgeMap<double>& weights);

/// The tree-cotree decomposition behind a greedy system of loops.
struct LoopSystem {
  VertexId basepoint;
  std::vector<EdgeLoop> loops;         ///< 2g, each from the basepoint to the basepoint
  std::vector<HalfedgeId> generators;  ///< the leftover edge of each loop, in the loop's direction
  /// Halfedge from the parent in the shortest-path tree; invalid at the root.
  VertexMap<HalfedgeId> tree_parent;
  double length = 0;  ///< sum over loops, in units of the weights
};

/// The shortest system of loops with this basepoint: T = shortest-path tree, C* = maximum spanning tree of
/// the dual of the edges not in T by the length of the loop that the edge closes, 2g edges left over. Ties
/// are broken by position (by index only where positions are equal or weights zero), so renumbering changes
/// nothing. Loops come ordered by length, the shorter first, and directed from the end of their generator
/// that is lexicographically smaller. Near linear time. \cite erickson2005, Section 3. Throws TopologyError
/// (not closed, not connected), InvalidInput (a weight that is negative or not finite).
LoopSystem greedy_loops(const Mesh& mesh, VertexId basepoint, const EdgeMap<double>& weights);

struct ShortestLoopsOptions {
  int evaluation_limit = 0;  ///< Stops with ConvergenceError after this many basepoints; 0: no limit.
};
struct ShortestLoopsResult {
  LoopSystem system;
  int evaluations = 0;  ///< basepoints whose loops were computed
};
/// The shortest over ALL basepoints, exactly, by best-first branch and bound on L(b') >= L(b) - 4g d(b, b'),
/// sharpened: the k-th shortest loop obeys l_k(b') >= l_k(b) - 2 d(b, b') on its own. Among equally short
/// ones (relative 1e-12) the basepoint of lexicographically smallest position wins, so renumbering changes
/// nothing. Throws as greedy_loops does, and TopologyError for a sphere.
ShortestLoopsResult shortest_loops(const Mesh& mesh, const EdgeMap<double>& lengths, const RunContext& ctx,
                                   const ShortestLoopsOptions& options = {});

/// The shortest loop at all that is not homologous to zero; cutting along it leaves the surface in one piece.
/// It meets no vertex twice. Found, tied and refused as shortest_loops: the first loop of the best basepoint.
EdgeLoop shortest_loop(const Mesh& mesh, const EdgeMap<double>& lengths, const RunContext& ctx,
                       const ShortestLoopsOptions& options = {});

/// Dijkstra by weights from one source; the parent halfedge of each vertex (invalid at the source).
/// \pre closed mesh (throws TopologyError), weights >= 0.
struct ShortestPaths {
  VertexMap<double> distance;
  VertexMap<HalfedgeId> parent;
};
ShortestPaths shortest_paths(const Mesh& mesh, VertexId source, const EdgeMap<double>& weights);
/// The walk from the source to v.
std::vector<HalfedgeId> path_to(const Mesh& mesh, const ShortestPaths& paths, VertexId v);

}  // namespace foramen
