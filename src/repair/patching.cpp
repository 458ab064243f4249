#include "repair/patching.hpp"

#include <algorithm>
#include <utility>

#include "foramen/core/error.hpp"
#include "repair/disk.hpp"

namespace foramen::repair_detail {
namespace {

// Vertices at which the remaining faces would form several fans.
std::vector<VertexId> pinches(const Mesh& mesh, const FaceSet& taken) {
  std::vector<VertexId> found;
  for (VertexId v : mesh.vertices()) {
    const auto fan = mesh.fan(v);
    int gaps = 0;
    for (std::size_t k = 0; k < fan.size(); ++k)
      if (taken[Mesh::face(fan[k])] == 0 && taken[Mesh::face(fan[(k + 1) % fan.size()])] != 0) ++gaps;
    if (gaps > 1) found.push_back(v);
  }
  return found;
}

// Adds all pieces of the remaining mesh except the largest one to `taken`.
void keep_largest_rest(const Mesh& mesh, FaceSet& taken) {
  FaceMap<int> piece(mesh.face_count(), -1);
  std::vector<int> size;
  for (FaceId seed : mesh.faces()) {
    if (taken[seed] != 0 || piece[seed] >= 0) continue;
    const int p = static_cast<int>(size.size());
    size.push_back(0);
    piece[seed] = p;
    std::vector<FaceId> stack{seed};
    while (!stack.empty()) {
      const FaceId f = stack.back();
      stack.pop_back();
      ++size.back();
      for (int k = 0; k < 3; ++k) {
        const FaceId g = Mesh::face(mesh.twin(Mesh::halfedge(f, k)));
        if (taken[g] != 0 || piece[g] >= 0) continue;
        piece[g] = p;
        stack.push_back(g);
      }
    }
  }
  const auto largest = static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  for (FaceId f : mesh.faces())
    if (piece[f] != largest) taken[f] = 1;
}

}  // namespace

EditedMesh unchanged(const Mesh& mesh) {
  EditedMesh same{mesh, VertexMap<VertexId>(mesh.vertex_count())};
  for (VertexId v : mesh.vertices()) same.origin[v] = v;
  return same;
}

VertexMap<VertexId> composed(const VertexMap<VertexId>& first, const VertexMap<VertexId>& second) {
  VertexMap<VertexId> out(second.size());
  for (VertexId v : second.ids())
    if (second[v].valid()) out[v] = first[second[v]];
  return out;
}

FaceSet grown(const Mesh& mesh, const FaceSet& faces) {
  FaceSet out = faces;
  for (FaceId f : mesh.faces()) {
    if (faces[f] == 0) continue;
    for (VertexId v : mesh.corners(f))
      for (HalfedgeId h : mesh.fan(v)) out[Mesh::face(h)] = 1;
  }
  return out;
}

FaceSet faces_along(const Mesh& mesh, const std::vector<HalfedgeId>& walk) {
  FaceSet out(mesh.face_count(), 0);
  for (HalfedgeId along : walk)
    for (HalfedgeId h : mesh.fan(mesh.from(along))) out[Mesh::face(h)] = 1;
  return out;
}

std::optional<EditedMesh> without_faces(const Mesh& mesh, FaceSet faces) {
  keep_largest_rest(mesh, faces);
  for (auto pinched = pinches(mesh, faces); !pinched.empty(); pinched = pinches(mesh, faces)) {
    for (VertexId v : pinched)
      for (HalfedgeId h : mesh.fan(v)) faces[Mesh::face(h)] = 1;
    keep_largest_rest(mesh, faces);
  }
  TriangleSoup soup;
  std::vector<int> index(mesh.vertex_count(), -1);
  for (FaceId f : mesh.faces())
    if (faces[f] == 0)
      for (VertexId v : mesh.corners(f)) index[v.index] = 0;
  std::vector<VertexId> origin;
  for (VertexId v : mesh.vertices()) {
    if (index[v.index] < 0) continue;
    index[v.index] = static_cast<int>(origin.size());
    origin.push_back(v);
    soup.points.push_back(mesh.position(v));
  }
  for (FaceId f : mesh.faces()) {
    if (faces[f] != 0) continue;
    auto t = mesh.triangles()[f.index];
    for (int& corner : t) corner = index[corner];
    soup.triangles.push_back(t);
  }
  if (soup.triangles.empty()) return std::nullopt;
  return EditedMesh{build_mesh(std::move(soup)), VertexMap<VertexId>(std::move(origin))};
}

std::vector<Border> borders(const Mesh& mesh) {
  std::vector<Border> found;
  HalfedgeMap<char> seen(mesh.halfedge_count(), 0);
  for (HalfedgeId first : mesh.halfedges()) {
    if (mesh.twin(first).valid() || seen[first] != 0) continue;
    Border border;
    // A boundary vertex has one boundary halfedge that leaves it.
    for (HalfedgeId h = first; seen[h] == 0; h = mesh.outgoing(mesh.to(h))) {
      FORAMEN_ASSERT(!mesh.twin(h).valid());
      seen[h] = 1;
      border.push_back(h);
    }
    found.push_back(std::move(border));
  }
  return found;
}

double border_length(const Mesh& mesh, const Border& border) {
  double length = 0;
  for (HalfedgeId h : border) length += (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
  return length;
}

Vec3 border_centre(const Mesh& mesh, const Border& border) {
  Vec3 sum = Vec3::Zero();
  for (HalfedgeId h : border) sum += mesh.position(mesh.from(h));
  return sum / static_cast<double>(border.size());
}

Mesh with_disks(const Mesh& open, Fairness fairness) {
  TriangleSoup soup = open.soup();
  for (const Border& border : borders(open)) {
    // The disk is wound against the direction of the border.
    std::vector<VertexId> loop;
    for (auto h = border.rbegin(); h != border.rend(); ++h) loop.push_back(open.to(*h));
    std::vector<Vec3> points;
    for (VertexId v : loop) points.push_back(open.position(v));
    const auto joined = [&](int i, int j) {
      const VertexId a = loop[i], b = loop[j];
      return open.find_halfedge(a, b).valid() || open.find_halfedge(b, a).valid();
    };
    const Disk disk = disk_of(points, joined);
    const int first = static_cast<int>(soup.points.size()), size = static_cast<int>(loop.size());
    soup.points.insert(soup.points.end(), disk.inner.begin(), disk.inner.end());
    for (std::array<int, 3> t : disk.triangles) {
      for (int& corner : t) corner = corner < size ? loop[corner].index : first + corner - size;
      soup.triangles.push_back(t);
    }
  }
  const Mesh closed = build_mesh(std::move(soup));
  std::vector<VertexId> added;
  for (int v = open.vertex_count(); v < closed.vertex_count(); ++v) added.emplace_back(v);
  return added.empty() ? closed : closed.with_positions(faired(closed, added, fairness));
}

}  // namespace foramen::repair_detail
