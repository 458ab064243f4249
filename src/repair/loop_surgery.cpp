#include "repair/loop_surgery.hpp"

#include "foramen/core/geometry.hpp"

namespace foramen::repair_detail {

Vec3 loop_centre(const Mesh& mesh, const EdgeLoop& loop) {
  Vec3 sum = Vec3::Zero();
  double length = 0;
  for (HalfedgeId h : loop) {
    const Vec3 &a = mesh.position(mesh.from(h)), &b = mesh.position(mesh.to(h));
    sum += (b - a).norm() * (a + b) / 2;
    length += (b - a).norm();
  }
  return length > 0 ? Vec3(sum / length) : mesh.position(mesh.from(loop.front()));
}

Mesh cut_and_closed(const Mesh& mesh, const EdgeLoop& loop) {
  TriangleSoup soup = mesh.soup();
  // The copy of a loop vertex for the faces to the right of the loop.
  VertexMap<int> right(mesh.vertex_count(), -1);
  for (HalfedgeId h : loop) {
    right[mesh.from(h)] = static_cast<int>(soup.points.size());
    soup.points.push_back(mesh.position(mesh.from(h)));
  }
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const HalfedgeId arriving = loop[i], leaving = loop[(i + 1) % loop.size()];
    // The faces to the right of the loop lie counter-clockwise between the reversed arriving and the leaving
    // halfedge.
    for (HalfedgeId h = mesh.twin(arriving); h != leaving; h = mesh.rotated(h))
      soup.triangles[h.index / 3][h.index % 3] = right[mesh.from(h)];
  }
  const int left_tip = static_cast<int>(soup.points.size()), right_tip = left_tip + 1;
  soup.points.insert(soup.points.end(), 2, loop_centre(mesh, loop));
  for (HalfedgeId h : loop) {
    const VertexId a = mesh.from(h), b = mesh.to(h);
    soup.triangles.push_back({b.index, a.index, left_tip});
    soup.triangles.push_back({right[a], right[b], right_tip});
  }
  return build_mesh(std::move(soup));
}

}  // namespace foramen::repair_detail
