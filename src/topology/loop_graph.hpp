#pragma once
// The inner engine of greedy systems of loops: everything that many basepoints of one mesh share (LoopGraph),
// and what one evaluation writes (LoopScratch). Plain contiguous arrays of indices: this is the hot part of
// the search over all basepoints.

#include <array>
#include <cstdint>
#include <vector>

#include "foramen/topology/shortest_loops.hpp"

namespace foramen::topology_detail {

/// Memory of one evaluation, kept between evaluations. One thread at a time may use it.
struct LoopScratch {
  std::vector<double> distance;  ///< per vertex: from the basepoint
  std::vector<int> parent;       ///< per vertex: halfedge that arrives from the tree's parent; -1 at the root
  std::vector<int> leftover;     ///< the 2g leftover edges, by length of their loops, the shorter first
  std::vector<double> loop_lengths;  ///< of the leftover edges

  struct Entry {
    double distance;
    int vertex;
  };
  std::vector<std::vector<Entry>> buckets;
  struct FaceState {
    int degree;      // dual edges left
    int neighbours;  // the faces across them, xor-ed: the index of the last one when one is left
  };
  std::vector<FaceState> faces;
  std::vector<int> stack, core, leader;  // faces to peel, edges of the core, union-find
};

/// A closed connected mesh with edge weights, ready for evaluations.
class LoopGraph {
 public:
  /// Throws TopologyError (open, not connected) or InvalidInput (a weight that is negative or not finite).
  LoopGraph(const Mesh& mesh, const EdgeMap<double>& weights);

  int vertex_count() const { return static_cast<int>(first_arc_.size()) - 1; }
  int loop_count() const { return loop_count_; }  ///< 2g
  LoopScratch scratch() const;

  /// Fills all results of the scratch. The loop lengths are the successive minima of the basepoint and so do
  /// not depend on how ties are broken; the tree and the leftover edges may.
  void evaluate(int basepoint, LoopScratch& s) const;

  /// The three parts of evaluate().
  void grow_tree(int basepoint, LoopScratch& s) const;
  /// Replaces the parents by those that depend on positions only, not on the numbering: among the neighbours
  /// that a shortest path may come from, the one with the lexicographically smallest position.
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
