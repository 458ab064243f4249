#include "repair/zero_area.hpp"

#include <algorithm>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "repair/disk.hpp"
#include "repair/words.hpp"

namespace foramen::repair_detail {
namespace {

// A side is collapsed if it is shorter than this part of the longest side.
constexpr double short_side = 0.01;
// The repair of a triangle may make another one degenerate, so a chain of them needs several rounds.
constexpr int most_rounds = 30;

double length(const Mesh& mesh, HalfedgeId h) {
  return (mesh.position(mesh.to(h)) - mesh.position(mesh.from(h))).norm();
}

std::vector<FaceId> degenerate_faces(const Mesh& mesh, double limit) {
  std::vector<FaceId> found;
  for (FaceId f : mesh.faces())
    if (!(area(mesh.triangle(f)) > limit)) found.push_back(f);
  return found;
}

// One round of changes with disjoint neighbourhoods.
class Round {
 public:
  Round(const Mesh& mesh, double limit)
      : mesh_(mesh), limit_(limit), soup_(mesh.soup()), touched_(mesh.vertex_count(), 0) {}

  bool mend(FaceId f) {
    const auto sides = std::array{Mesh::halfedge(f, 0), Mesh::halfedge(f, 1), Mesh::halfedge(f, 2)};
    const auto [shortest, longest] =
        std::minmax_element(sides.begin(), sides.end(),
                            [&](HalfedgeId a, HalfedgeId b) { return length(mesh_, a) < length(mesh_, b); });
    if (length(mesh_, *shortest) <= short_side * length(mesh_, *longest) && collapse(*shortest)) return true;
    return flip(*longest);
  }

  EditedMesh result() {
    soup_.triangles.erase(
        std::remove_if(soup_.triangles.begin(), soup_.triangles.end(),
                       [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }),
        soup_.triangles.end());
    std::vector<int> index(soup_.points.size(), -1);
    for (const auto& t : soup_.triangles)
      for (int corner : t) index[corner] = 0;
    std::vector<VertexId> origin;
    TriangleSoup kept;
    for (VertexId v : mesh_.vertices()) {
      if (index[v.index] < 0) continue;
      index[v.index] = static_cast<int>(origin.size());
      origin.push_back(v);
      kept.points.push_back(mesh_.position(v));
    }
    for (auto t : soup_.triangles) {
      for (int& corner : t) corner = index[corner];
      kept.triangles.push_back(t);
    }
    return {build_mesh(std::move(kept)), VertexMap<VertexId>(std::move(origin))};
  }

 private:
  std::vector<VertexId> ring(VertexId v) const {
    std::vector<VertexId> out;
    for (HalfedgeId h : mesh_.fan(v)) out.push_back(mesh_.to(h));
    std::sort(out.begin(), out.end());
    return out;
  }

  bool take(std::vector<VertexId> vertices) {
    if (std::any_of(vertices.begin(), vertices.end(), [&](VertexId v) { return touched_[v] != 0; }))
      return false;
    for (VertexId v : vertices) touched_[v] = 1;
    return true;
  }

  // Two vertices may be merged if their only common neighbours are the opposite corners of the two triangles.
  bool collapse(HalfedgeId side) {
    const VertexId a = mesh_.from(side), b = mesh_.to(side);
    std::vector<VertexId> at_a = ring(a), at_b = ring(b), common;
    std::set_intersection(at_a.begin(), at_a.end(), at_b.begin(), at_b.end(), std::back_inserter(common));
    if (common.size() != 2 || at_a.size() + at_b.size() < 8) return false;
    at_a.insert(at_a.end(), at_b.begin(), at_b.end());
    if (!take(at_a)) return false;
    const auto [kept, gone] = std::minmax(a, b);
    for (HalfedgeId h : mesh_.fan(gone)) soup_.triangles[h.index / 3][h.index % 3] = kept.index;
    return true;
  }

  bool flip(HalfedgeId side) {
    const HalfedgeId twin = mesh_.twin(side);
    const VertexId a = mesh_.from(side), b = mesh_.to(side), c = mesh_.to(Mesh::next(side)),
                   d = mesh_.to(Mesh::next(twin));
    if (c == d || mesh_.find_halfedge(c, d).valid()) return false;
    const auto p = [&](VertexId v) { return mesh_.position(v); };
    if (!(area({p(c), p(d), p(b)}) > limit_) || !(area({p(d), p(c), p(a)}) > limit_)) return false;
    if (!take({a, b, c, d})) return false;
    soup_.triangles[Mesh::face(side).index] = {c.index, d.index, b.index};
    soup_.triangles[Mesh::face(twin).index] = {d.index, c.index, a.index};
    return true;
  }

  const Mesh& mesh_;
  double limit_;
  TriangleSoup soup_;
  VertexMap<char> touched_;
};

// Replaces the triangles around a face by a disk; nullopt if they are not a disk.
std::optional<EditedMesh> replaced(const Mesh& mesh, FaceId f) {
  FaceSet faces(mesh.face_count(), 0);
  faces[f] = 1;
  const auto open = without_faces(mesh, grown(mesh, faces));
  if (!open) return std::nullopt;
  const auto holes = borders(open->mesh);
  if (holes.size() != 1 || holes[0].size() > most_loop_points) return std::nullopt;
  EditedMesh closed{with_disks(open->mesh, Fairness::membrane), open->origin};
  if (closed.mesh.euler_characteristic() != mesh.euler_characteristic()) return std::nullopt;
  closed.origin.values().resize(closed.mesh.vertex_count());
  return closed;
}

}  // namespace

WithoutZeroArea without_zero_area(const Mesh& mesh) {
  WithoutZeroArea out{unchanged(mesh), {}};
  const double limit = degenerate_area(bounding_box(mesh.positions()).diagonal());
  auto faces = degenerate_faces(mesh, limit);
  for (FaceId f : faces)
    out.positions.emplace_back((mesh.triangle(f)[0] + mesh.triangle(f)[1] + mesh.triangle(f)[2]) / 3);
  Mesh now = mesh;
  for (int round = 0; round < most_rounds && !faces.empty(); ++round) {
    Round changes(now, limit);
    int mended = 0;
    for (FaceId f : faces) mended += changes.mend(f) ? 1 : 0;
    std::optional<EditedMesh> next;
    if (mended > 0)
      next = changes.result();
    else
      for (std::size_t k = 0; k < faces.size() && !next; ++k) next = replaced(now, faces[k]);
    if (!next) break;
    out.edited.origin = composed(out.edited.origin, next->origin);
    now = next->mesh;
    faces = degenerate_faces(now, limit);
  }
  if (!faces.empty())
    throw InvalidInput("a triangle without area cannot be removed, near " + shown(now.triangle(faces[0])[0]) +
                       "; delete the faces there in a mesh editor and close the hole");
  out.edited.mesh = now;
  return out;
}

}  // namespace foramen::repair_detail
