#include "repair/meeting_places.hpp"

#include "repair/edge_sides.hpp"

namespace foramen::repair_detail {

MeetingPlaces::MeetingPlaces(const Mesh& mesh, const std::vector<std::pair<FaceId, FaceId>>& pairs)
    : ring(mesh.vertex_count(), -1), of_vertex(mesh.vertex_count(), -1), of_face(mesh.face_count(), -1) {
  std::vector<VertexId> front;
  const auto reach = [&](VertexId v, int at_ring) {
    if (ring[v] >= 0) return;
    ring[v] = at_ring;
    front.push_back(v);
  };
  for (const auto& [f, g] : pairs)
    for (FaceId face : {f, g})
      for (VertexId v : mesh.corners(face)) reach(v, 0);
  for (int r = 1; r <= place_rings; ++r) {
    const std::vector<VertexId> inner = std::exchange(front, {});
    for (VertexId v : inner)
      for (HalfedgeId h : mesh.fan(v)) reach(mesh.to(h), r);
  }

  // Vertices of a place that share a face belong to one place, and so do the two triangles of a pair.
  DisjointSets sets(mesh.vertex_count());
  const auto at = [](VertexId v) { return v.index; };
  for (FaceId f : mesh.faces()) {
    VertexId first;
    for (VertexId v : mesh.corners(f)) {
      if (ring[v] < 0) continue;
      if (first.valid()) sets.join(at(first), at(v));
      first = v;
    }
  }
  for (const auto& [f, g] : pairs) sets.join(at(mesh.corners(f)[0]), at(mesh.corners(g)[0]));
  VertexMap<int> number(mesh.vertex_count(), -1);
  for (VertexId v : mesh.vertices()) {
    if (ring[v] < 0) continue;
    int& n = number[VertexId(static_cast<int>(sets.root(at(v))))];
    if (n < 0) n = count++;
    of_vertex[v] = n;
  }
  for (FaceId f : mesh.faces())
    for (VertexId v : mesh.corners(f))
      if (of_vertex[v] >= 0) of_face[f] = of_vertex[v];
}

}  // namespace foramen::repair_detail
