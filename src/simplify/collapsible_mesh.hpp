#pragma once
/// \file
/// A closed triangle mesh that is simplified by halfedge collapses and keeps its face ids.

#include <array>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "simplify/working_mesh.hpp"

namespace foramen {

/// Halfedges are numbered as in Mesh (3f+k). After a collapse the halfedges of dropped faces must not be
/// used.
class CollapsibleMesh {
 public:
  /// \pre closed
  explicit CollapsibleMesh(const Mesh& mesh);

  int vertex_count() const { return vertex_count_; }
  bool alive(VertexId v) const { return outgoing_[v].valid(); }
  bool alive(FaceId f) const { return triangles_[f.index][0] >= 0; }
  const std::array<int, 3>& corners(FaceId f) const { return triangles_[f.index]; }
  int valence(VertexId v) const { return valence_[v]; }
  VertexId from(HalfedgeId h) const { return VertexId(triangles_[h.index / 3][h.index % 3]); }
  VertexId to(HalfedgeId h) const { return from(Mesh::next(h)); }
  VertexId apex(HalfedgeId h) const { return from(Mesh::prev(h)); }
  HalfedgeId twin(HalfedgeId h) const { return twin_[h]; }
  HalfedgeId outgoing(VertexId v) const { return outgoing_[v]; }
  /// The next outgoing halfedge counter-clockwise about from(h).
  HalfedgeId rotated(HalfedgeId h) const { return twin_[Mesh::prev(h)]; }
  /// All outgoing halfedges counter-clockwise from `first` on.
  void fan(HalfedgeId first, std::vector<HalfedgeId>& out) const;

  /// Whether the two ends have exactly two common neighbours. If and only if this holds, the collapse
  /// preserves the topology and creates no second edge between two vertices.
  bool link_condition(HalfedgeId h);
  /// Merges from(h) into to(h). \pre link_condition(h)
  Collapse collapse(HalfedgeId h);

 private:
  void glue(HalfedgeId a, HalfedgeId b);

  std::vector<std::array<int, 3>> triangles_;
  HalfedgeMap<HalfedgeId> twin_;
  VertexMap<HalfedgeId> outgoing_;
  VertexMap<int> valence_;
  VertexMap<int> mark_;  // for link_condition(): the number of the call that marked the vertex
  int marks_ = 0;
  int vertex_count_ = 0;
};

}  // namespace foramen
