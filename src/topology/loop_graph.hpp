#pragma once
// The inner loop of the search for shortest systems of loops. LoopGraph holds what all basepoints of a mesh
// share and LoopScratch what the evaluation of one basepoint writes. Both are plain arrays of indices for
// speed.

#include <array>
#include <cstdint>
#include <vector>

#include "foramen/topology/shortest_loops.hpp"

namespace foramen::topology_detail {

/// Working memory of an evaluation, reused by later evaluations. Each thread needs its own.
struct LoopScratch {
  std::vector<double> distance;      ///< per vertex: from the basepoint
  std::vector<int> parent;           ///< per vertex: the halfedge from its parent in the tree; -1 at the root
  std::vector<int> leftover;         ///< the 2g edges in neither tree, in order of the lengths of their loops
  std::vector<double> loop_lengths;  ///< of the leftover edges

  struct Entry {
    double distance;
    int vertex;
  };
  std::vector<std::vector<Entry>> buckets;
  struct FaceState {
    int degree;      // number of remaining dual edges
    int neighbours;  // xor of the faces across them; if one edge remains, the index of its face
  };
  std::vector<FaceState> faces;
  std::vector<int> stack, core, leader;  // leaves to remove, edges of the core, union-find
};

/// A closed connected mesh with edge weights, prepared for the evaluation of basepoints.
class LoopGraph {
 public:
  /// Throws TopologyError (open, not connected) or InvalidInput (a weight that is negative or not finite).
  LoopGraph(const Mesh& mesh, const EdgeMap<double>& weights);

  int vertex_count() const { return static_cast<int>(first_arc_.size()) - 1; }
  int loop_count() const { return loop_count_; }  ///< 2g
  LoopScratch scratch() const;

  /// Computes all results in the scratch. The loop lengths are the successive minima of the basepoint and do
  /// not depend on how ties are broken; the tree and the leftover edges do.
  void evaluate(int basepoint, LoopScratch& s) const;

  /// The three parts of evaluate().
  void grow_tree(int basepoint, LoopScratch& s) const;
  /// Replaces each parent by the neighbour of lexicographically smallest position among those on a shortest
  /// path, so that the tree does not depend on the numbering.
  void choose_parents_by_position(LoopScratch& s) const;
  void find_leftover(LoopScratch& s) const;

 private:
  struct Arc {
    int to;
    int halfedge;  // runs to `to`
    double weight;
  };
  void peel(LoopScratch& s) const;
  void collect_core(LoopScratch& s) const;
  bool in_tree(HalfedgeId h, const LoopScratch& s) const;
  double loop_length(int edge, const std::vector<double>& distance) const;

  Mesh mesh_;
  std::vector<int> first_arc_;  // arcs leaving vertex v: first_arc_[v] .. first_arc_[v + 1] - 1
  std::vector<Arc> arcs_;
  std::vector<double> weight_;                     // per edge
  std::vector<std::array<int, 2>> edge_vertices_;  // per edge
  std::vector<LoopScratch::FaceState> whole_faces_;
  std::vector<int> face_across_;  // per halfedge
  double buckets_per_length_ = 1;
  std::size_t bucket_count_ = 1;  // a power of two
  int loop_count_ = 0;
};

/// Whether vertex a comes before b: by position, lexicographically; by index only where positions are equal.
bool position_less(const Mesh& mesh, VertexId a, VertexId b);

}  // namespace foramen::topology_detail
