#include "sampling/thin_out.hpp"

#include <queue>
#include <string>

#include "sampling/delaunay_flips.hpp"

namespace foramen::detail {
namespace {

// Share of the vertices that one stage leaves. Flips between the stages keep triangles round and valences
// low.
constexpr double stage_share = 0.7;
// A collapse is postponed if the cosine between the old and the new normal of a triangle is below this.
constexpr double turned_normal_cosine = 0.2;

/// An edge, ordered by scaled length and, for equal lengths, by its vertices, so that the order is
/// deterministic.
struct Candidate {
  double length2;
  int from, to, halfedge;
  friend bool operator>(const Candidate& a, const Candidate& b) {
    if (a.length2 != b.length2) return a.length2 > b.length2;
    return std::pair(a.from, a.to) > std::pair(b.from, b.to);
  }
};

bool current(const LandmarkState& s, const Candidate& c) {
  return s.mesh.face_alive(c.halfedge / 3) && s.mesh.from(c.halfedge) == c.from &&
         s.mesh.to(c.halfedge) == c.to;
}

double crowding(const LandmarkState& s, int v) {
  double sum = 0;
  int count = 0;
  s.mesh.for_each_outgoing(v, [&](int h) {
    sum += s.scaled_length2(h);
    ++count;
  });
  return sum / count;
}

bool turns_a_normal(const LandmarkState& s, int h) {
  const Vec3 &u = s.point[s.mesh.from(h)], &w = s.point[s.mesh.to(h)];
  bool turned = false;
  s.mesh.for_each_outgoing(s.mesh.from(h), [&](int g) {
    if (g / 3 == h / 3 || g / 3 == s.mesh.twin(h) / 3) return;
    const Vec3 &a = s.point[s.mesh.to(g)], &b = s.point[s.mesh.apex(g)];
    turned |= cosine(doubled_area_vector(u, a, b), doubled_area_vector(w, a, b)) < turned_normal_cosine;
  });
  return turned;
}

/// Collapses edges until `target` vertices are left or the queue is empty.
void collapse_stage(LandmarkState& s, int target, bool keep_normals) {
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue;
  const auto push = [&](int h) {
    const int a = s.mesh.from(h), b = s.mesh.to(h);
    queue.push(a < b ? Candidate{s.scaled_length2(h), a, b, h}
                     : Candidate{s.scaled_length2(h), b, a, s.mesh.twin(h)});
  };
  for (int h = 0; h < s.mesh.halfedge_slots(); ++h)
    if (s.mesh.face_alive(h / 3) && s.mesh.from(h) < s.mesh.to(h)) push(h);

  const auto try_collapse = [&](int h) {
    if (!s.mesh.can_collapse(h) || (keep_normals && turns_a_normal(s, h))) return false;
    const int kept = s.mesh.to(h);
    s.mesh.collapse(h);
    s.mesh.for_each_outgoing(kept, push);
    return true;
  };
  while (s.mesh.vertex_count() > target && !queue.empty()) {
    const Candidate c = queue.top();
    queue.pop();
    if (!current(s, c)) continue;
    // First tries to remove the end in the more crowded neighbourhood.
    const bool from_first = crowding(s, c.from) <= crowding(s, c.to);
    const int first = from_first ? c.halfedge : s.mesh.twin(c.halfedge);
    const int second = s.mesh.twin(first);
    if (!try_collapse(first)) try_collapse(second);
  }
}

}  // namespace

void thin_out(LandmarkState& s, int vertices, const RunContext& ctx) {
  bool keep_normals = true;
  while (s.mesh.vertex_count() > vertices) {
    ctx.check();
    const int before = s.mesh.vertex_count();
    const int target = std::max(vertices, static_cast<int>(stage_share * before));
    collapse_stage(s, target, keep_normals);
    const int flips = delaunay_flips(s, ctx);
    if (s.mesh.vertex_count() < before) continue;
    if (!keep_normals && flips == 0)
      throw ConvergenceError("remesh: no vertex can be removed any more at " + std::to_string(before) +
                             " vertices; ask for that many landmarks or more");
    keep_normals = false;
  }
}

void fill_up(LandmarkState& s, int vertices, const DenseSurface& surface, const RunContext& ctx) {
  while (s.mesh.vertex_count() < vertices) {
    ctx.check();
    std::vector<Candidate> edges;
    for (int h = 0; h < s.mesh.halfedge_slots(); ++h)
      if (s.mesh.from(h) < s.mesh.to(h))
        edges.push_back({s.scaled_length2(h), s.mesh.from(h), s.mesh.to(h), h});
    std::sort(edges.begin(), edges.end(), std::greater<>());
    const int before = s.mesh.vertex_count();
    // Splits up to a quarter of the edges, the longest first, without sorting again. An edge whose length has
    // changed meanwhile waits for the next round.
    for (std::size_t i = 0; i <= edges.size() / 4 && s.mesh.vertex_count() < vertices; ++i) {
      if (!current(s, edges[i])) continue;
      const int m = s.mesh.split_edge(edges[i].halfedge);
      if (m < 0) continue;
      s.point.resize(static_cast<std::size_t>(m) + 1);
      s.density.resize(static_cast<std::size_t>(m) + 1);
      s.update(m, surface);
    }
    if (s.mesh.vertex_count() == before)
      throw ConvergenceError("remesh: no edge can be split any more at " + std::to_string(before) +
                             " vertices");
    delaunay_flips(s, ctx);
  }
}

}  // namespace foramen::detail
