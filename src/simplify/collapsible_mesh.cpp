#include "simplify/collapsible_mesh.hpp"

#include "foramen/core/error.hpp"

namespace foramen {

CollapsibleMesh::CollapsibleMesh(const Mesh& mesh)
    : triangles_(mesh.triangles()),
      twin_(mesh.halfedge_count()),
      outgoing_(mesh.vertex_count()),
      valence_(mesh.vertex_count(), 0),
      mark_(mesh.vertex_count(), 0),
      vertex_count_(mesh.vertex_count()) {
  for (HalfedgeId h : mesh.halfedges()) {
    twin_[h] = mesh.twin(h);
    ++valence_[mesh.from(h)];
  }
  for (VertexId v : mesh.vertices()) outgoing_[v] = mesh.outgoing(v);
}

void CollapsibleMesh::fan(HalfedgeId first, std::vector<HalfedgeId>& out) const {
  out.clear();
  HalfedgeId h = first;
  do {
    out.push_back(h);
    h = rotated(h);
  } while (h != first);
}

bool CollapsibleMesh::link_condition(HalfedgeId h) {
  ++marks_;
  const HalfedgeId back = twin(h);
  for (HalfedgeId k = rotated(back); k != back; k = rotated(k)) mark_[to(k)] = marks_;
  int common = 0;
  for (HalfedgeId k = rotated(h); k != h; k = rotated(k)) common += mark_[to(k)] == marks_;
  // The two apexes are always common neighbours. A tetrahedron satisfies the condition too, but its collapse
  // would leave no surface.
  return common == 2 && apex(h) != apex(back) && vertex_count_ > 4;
}

void CollapsibleMesh::glue(HalfedgeId a, HalfedgeId b) {
  twin_[a] = b;
  twin_[b] = a;
}

Collapse CollapsibleMesh::collapse(HalfedgeId h) {
  const HalfedgeId back = twin(h);
  const VertexId removed = from(h), kept = to(h), left = apex(h), right = apex(back);
  Collapse record{.removed = removed,
                  .kept = kept,
                  .dropped_faces = {Mesh::face(h), Mesh::face(back)},
                  .dropped_corners = {},
                  .moved_faces = {}};
  record.moved_faces.reserve(valence(removed) - 2);
  for (HalfedgeId k = rotated(h); Mesh::face(k) != record.dropped_faces[1]; k = rotated(k))
    record.moved_faces.push_back(Mesh::face(k));
  for (std::size_t i = 0; i < 2; ++i) {
    auto& dropped = triangles_[record.dropped_faces[i].index];
    for (std::size_t k = 0; k < 3; ++k) record.dropped_corners[i][k] = VertexId(dropped[k]);
  }

  for (FaceId f : record.moved_faces)
    for (int& corner : triangles_[f.index])
      if (corner == removed.index) corner = kept.index;

  // The two other edges of each dropped face become one edge. The halfedges on their outer sides survive.
  const HalfedgeId to_left = twin(Mesh::prev(h)), from_left = twin(Mesh::next(h));
  const HalfedgeId from_right = twin(Mesh::next(back)), to_right = twin(Mesh::prev(back));
  glue(to_left, from_left);
  glue(to_right, from_right);
  outgoing_[kept] = to_left;
  outgoing_[left] = from_left;
  outgoing_[right] = from_right;
  outgoing_[removed] = HalfedgeId();
  valence_[kept] += valence_[removed] - 4;
  valence_[removed] = 0;
  --valence_[left];
  --valence_[right];
  --vertex_count_;
  for (FaceId f : record.dropped_faces) triangles_[f.index] = {-1, -1, -1};
  return record;
}

}  // namespace foramen
