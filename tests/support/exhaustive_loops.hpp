#pragma once
/// \file
/// The reference for shortest_loops(): every basepoint, plain Dijkstra, and plain Kruskal over all dual
/// edges. The only code that it shares with the search is greedy_loops(), which makes the result.

#include <algorithm>
#include <utility>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "foramen/topology/shortest_loops.hpp"

namespace foramen::testing {

namespace detail {

// The groups of faces that have been joined (union-find).
class Groups {
 public:
  explicit Groups(int count) : leader_(count), size_(count, 1) {
    for (FaceId f : leader_.ids()) leader_[f] = f;
  }
  /// Joins the groups of two faces. Returns false if the faces were already in one group.
  bool join(FaceId a, FaceId b) {
    a = leader_of(a);
    b = leader_of(b);
    if (a == b) return false;
    if (size_[a] > size_[b]) std::swap(a, b);
    leader_[a] = b;
    size_[b] += size_[a];
    return true;
  }

 private:
  FaceId leader_of(FaceId f) const {
    while (leader_[f] != f) f = leader_[f];
    return f;
  }
  FaceMap<FaceId> leader_;
  FaceMap<int> size_;
};

inline double system_length(const Mesh& mesh, VertexId basepoint, const EdgeMap<double>& lengths) {
  const ShortestPaths paths = shortest_paths(mesh, basepoint, lengths);
  EdgeMap<bool> in_tree(mesh.edge_count(), false);
  for (HalfedgeId h : paths.parent)
    if (h.valid()) in_tree[mesh.edge(h)] = true;
  struct Candidate {
    double length;
    EdgeId edge;
  };
  std::vector<Candidate> candidates;
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    if (!in_tree[e])
      candidates.push_back({paths.distance[mesh.from(h)] + paths.distance[mesh.to(h)] + lengths[e], e});
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return a.length != b.length ? a.length > b.length : a.edge < b.edge;
  });
  Groups groups(mesh.face_count());
  double total = 0;
  for (const Candidate& c : candidates) {
    const HalfedgeId h = mesh.halfedge(c.edge);
    if (!groups.join(Mesh::face(h), Mesh::face(mesh.twin(h)))) total += c.length;
  }
  return total;
}

}  // namespace detail

/// The shortest loops over all basepoints, by exhaustive search.
inline LoopSystem shortest_loops_exhaustive(const Mesh& mesh, const EdgeMap<double>& lengths,
                                            const RunContext& ctx) {
  VertexMap<double> total(mesh.vertex_count());
  parallel_for(mesh.vertex_count(), ctx,
               [&](int v) { total[VertexId(v)] = detail::system_length(mesh, VertexId(v), lengths); });
  const auto best = std::min_element(total.begin(), total.end());
  if (best == total.end()) throw TopologyError("a system of loops needs a surface, found none");
  return greedy_loops(mesh, VertexId(static_cast<int>(best - total.begin())), lengths);
}

}  // namespace foramen::testing
