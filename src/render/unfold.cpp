#include "render/unfold.hpp"

#include <vector>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// Places a face whose corner at h has this shift.
void place(const TorusMap& map, HalfedgeId h, const Vec2i& shift, UnfoldedMap& unfolded) {
  const HalfedgeId second = Mesh::next(h), third = Mesh::next(second);
  unfolded.shift[h] = shift;
  unfolded.shift[second] = shift + map.jumps[h];
  unfolded.shift[third] = shift - map.jumps[third];
}

}  // namespace

UnfoldedMap unfold(const Mesh& mesh, const TorusMap& map, const EdgeMap<bool>& cut) {
  FORAMEN_ASSERT(mesh.is_closed() && cut.size() == mesh.edge_count());
  UnfoldedMap unfolded{HalfedgeMap<Vec2i>(mesh.halfedge_count(), Vec2i::Zero())};
  FaceMap<bool> placed(mesh.face_count(), false);
  std::vector<FaceId> queue;
  queue.reserve(mesh.face_count());
  std::size_t next = 0;
  for (FaceId first : mesh.faces()) {
    if (placed[first]) continue;
    placed[first] = true;
    place(map, Mesh::halfedge(first, 0), Vec2i::Zero(), unfolded);
    queue.push_back(first);
    for (; next < queue.size(); ++next)
      for (int k = 0; k < 3; ++k) {
        const HalfedgeId h = Mesh::halfedge(queue[next], k), twin = mesh.twin(h);
        if (cut[mesh.edge(h)] || placed[Mesh::face(twin)]) continue;
        placed[Mesh::face(twin)] = true;
        place(map, twin, unfolded.shift[Mesh::next(h)], unfolded);
        queue.push_back(Mesh::face(twin));
      }
  }
  return unfolded;
}

}  // namespace foramen
