#include "sampling/delaunay_flips.hpp"

#include <deque>

namespace foramen::detail {
namespace {

// An edge is flipped only if the sine of the excess of its opposite angles over pi exceeds this, so four
// cocircular points stay as they are.
constexpr double worthwhile_excess = 1e-9;
// The normals of the new triangles may always have this cosine, even if the old ones had a larger one.
constexpr double harmless_fold_cosine = 0.8;
// Delaunay flips on a surface in space may cycle, so each edge is tested at most this often on average.
constexpr int looks_per_edge = 10;

/// Sine of the sum of the angles opposite to the edge ab in the triangles abc and bad; negative if the edge
/// is not Delaunay.
double delaunay_sine(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ca = a - c, cb = b - c, da = a - d, db = b - d;
  const double sin_c = ca.cross(cb).norm(), cos_c = ca.dot(cb), sin_d = da.cross(db).norm(),
               cos_d = da.dot(db);
  const double scale = std::hypot(sin_c, cos_c) * std::hypot(sin_d, cos_d);
  return scale > 0 ? (sin_c * cos_d + cos_c * sin_d) / scale : 0.0;
}

bool wants_flip(const LandmarkState& s, int h) {
  const Vec3 &a = s.point[s.mesh.from(h)], &b = s.point[s.mesh.to(h)];
  const Vec3 &c = s.point[s.mesh.apex(h)], &d = s.point[s.mesh.apex(s.mesh.twin(h))];
  if (delaunay_sine(a, b, c, d) >= -worthwhile_excess) return false;
  const double before = cosine(doubled_area_vector(a, b, c), doubled_area_vector(b, a, d));
  const double after = cosine(doubled_area_vector(d, b, c), doubled_area_vector(d, c, a));
  return after >= std::min(before, harmless_fold_cosine) && s.mesh.can_flip(h);
}

}  // namespace

int delaunay_flips(LandmarkState& s, const RunContext& ctx) {
  ctx.check();
  const int slots = s.mesh.halfedge_slots();
  std::deque<int> queue;
  std::vector<char> waiting(slots, 0);
  const auto push = [&](int h) {
    const int edge = std::min(h, s.mesh.twin(h));
    if (waiting[edge]) return;
    waiting[edge] = 1;
    queue.push_back(edge);
  };
  for (int h = 0; h < slots; ++h)
    if (s.mesh.face_alive(h / 3) && h < s.mesh.twin(h)) push(h);

  int flips = 0;
  long looks = looks_per_edge * static_cast<long>(queue.size());
  while (!queue.empty() && looks-- > 0) {
    const int h = queue.front();
    queue.pop_front();
    waiting[h] = 0;
    if (!wants_flip(s, h)) continue;
    const int diagonal = s.mesh.flip(h);
    ++flips;
    const int t = s.mesh.twin(diagonal);
    for (int g : {TorusTriangulation::next(diagonal), TorusTriangulation::prev(diagonal),
                  TorusTriangulation::next(t), TorusTriangulation::prev(t)})
      push(g);
  }
  return flips;
}

}  // namespace foramen::detail
