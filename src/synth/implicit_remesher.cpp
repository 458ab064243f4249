#include "synth/implicit_remesher.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>
#include <tuple>

#include "foramen/core/error.hpp"

namespace foramen::synth {
namespace {

constexpr double newton_tolerance_mm = 1e-11;
constexpr int newton_steps = 30;
constexpr double split_ratio = 4.0 / 3.0, collapse_ratio = 4.0 / 5.0;  // [botsch2004]
constexpr double least_facing_cosine =
    0.2;  // least cosine between the normal of a new triangle and that of the surface
constexpr double smoothing_step = 0.6;
constexpr int least_valence = 4;  // least valence that a collapse or flip may leave

double cotangent(const Vec3& apex, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - apex, v = b - apex;
  const double sine = u.cross(v).norm();
  return sine > 0 ? u.dot(v) / sine : std::copysign(std::numeric_limits<double>::infinity(), u.dot(v));
}

// Cosine of the angle between the normal of a triangle and a direction; 0 for a triangle of zero area.
double facing_cosine(const std::array<Vec3, 3>& triangle, const Vec3& direction) {
  return unit_normal(triangle).dot(direction) / direction.norm();
}

bool faces_outward(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& direction) {
  return facing_cosine({a, b, c}, direction) > least_facing_cosine;
}

}  // namespace

Projected projected(const ImplicitFunction& function, const Vec3& from, double longest_step_mm) {
  Vec3 p = from;
  ImplicitValue f = function(p);
  for (int k = 0; k < newton_steps && std::abs(f.value) > newton_tolerance_mm; ++k) {
    Vec3 step = -f.value / f.gradient.squaredNorm() * f.gradient;
    const double length = step.norm();
    if (length > longest_step_mm) step *= longest_step_mm / length;
    p += step;
    f = function(p);
  }
  return {p, f.gradient.normalized(), std::abs(f.value)};
}

ImplicitRemesher::ImplicitRemesher(const ImplicitFunction& function, TriangleSoup soup, double spacing_mm)
    : function_(function),
      step_limit_(0.5 * spacing_mm),
      vertex_count_(static_cast<int>(soup.points.size())),
      points_(std::move(soup.points)),
      faces_(std::move(soup.triangles)),
      star_(points_.size()) {
  for (Vec3& p : points_) {
    const Projected on = projected(function_, p, step_limit_);
    p = on.point;
    normals_.push_back(on.normal);
  }
  for (std::size_t f = 0; f < faces_.size(); ++f)
    for (int v : faces_[f]) star_[v].push_back(static_cast<int>(f));
}

double ImplicitRemesher::area() const {
  double sum = 0;
  for (const Triangle& t : faces_)
    if (t[0] >= 0) sum += foramen::area({points_[t[0]], points_[t[1]], points_[t[2]]});
  return sum;
}

double ImplicitRemesher::residual() const {
  double largest = 0;
  for (std::size_t v = 0; v < points_.size(); ++v)
    if (alive(static_cast<int>(v))) largest = std::max(largest, std::abs(function_(points_[v]).value));
  return largest;
}

TriangleSoup ImplicitRemesher::soup() const {
  TriangleSoup out;
  std::vector<int> index(points_.size(), -1);
  for (std::size_t v = 0; v < points_.size(); ++v)
    if (alive(static_cast<int>(v))) {
      index[v] = static_cast<int>(out.points.size());
      out.points.push_back(points_[v]);
    }
  for (const Triangle& t : faces_)
    if (t[0] >= 0) out.triangles.push_back({index[t[0]], index[t[1]], index[t[2]]});
  return out;
}

double ImplicitRemesher::length(int a, int b) const { return (points_[a] - points_[b]).norm(); }

std::vector<ImplicitRemesher::Edge> ImplicitRemesher::edges(double shortest, double longest) const {
  std::vector<Edge> all;
  for (const Triangle& t : faces_) {
    if (t[0] < 0) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if (a > b) continue;
      const double l = length(a, b);
      if (l >= shortest && l <= longest) all.push_back({l, a, b});
    }
  }
  return all;
}

bool ImplicitRemesher::adjacent(int a, int b) const {
  return std::ranges::any_of(star_[a],
                             [&](int f) { return std::ranges::find(faces_[f], b) != faces_[f].end(); });
}

std::vector<int> ImplicitRemesher::neighbours(int v) const {
  std::vector<int> ring;
  for (int f : star_[v])
    for (int w : faces_[f])
      if (w != v) ring.push_back(w);
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

ImplicitRemesher::EdgeFaces ImplicitRemesher::edge_faces(int a, int b) const {
  EdgeFaces found;
  for (int f : star_[a]) {
    const Triangle& t = faces_[f];
    for (std::size_t k = 0; k < 3; ++k) {
      const int p = t[k], q = t[(k + 1) % 3], apex = t[(k + 2) % 3];
      if (p == a && q == b) found.left = f, found.above = apex;
      if (p == b && q == a) found.right = f, found.below = apex;
    }
  }
  return found;
}

bool ImplicitRemesher::may_move(int v, const Projected& to, std::array<int, 2> except) const {
  for (int f : star_[v]) {
    if (f == except[0] || f == except[1]) continue;
    std::array<Vec3, 3> before, after;
    Vec3 direction_before = Vec3::Zero(), direction_after = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const int w = faces_[f][k];
      before[k] = points_[w];
      after[k] = w == v ? to.point : before[k];
      direction_before += normals_[w];
      direction_after += w == v ? to.normal : normals_[w];
    }
    const double facing = facing_cosine(after, direction_after);
    if (facing < least_facing_cosine && facing < facing_cosine(before, direction_before)) return false;
  }
  return true;
}

double ImplicitRemesher::longest_edge_after_move(int v, const Vec3& to) const {
  double longest = 0;
  for (int w : neighbours(v)) longest = std::max(longest, (points_[w] - to).norm());
  return longest;
}

void ImplicitRemesher::replace_corner(int face, int from, int to) {
  std::ranges::replace(faces_[face], from, to);
  star_[to].push_back(face);
}

void ImplicitRemesher::detach(int face, int vertex) { std::erase(star_[vertex], face); }

bool ImplicitRemesher::collapse(int a, int b, double longest_allowed) {
  const EdgeFaces e = edge_faces(a, b);
  if (e.left < 0 || e.right < 0) return false;
  if (static_cast<int>(star_[e.above].size()) <= least_valence ||
      static_cast<int>(star_[e.below].size()) <= least_valence)
    return false;
  // Link condition: the only common neighbours of the two ends are the two opposite corners.
  const std::vector<int> of_a = neighbours(a), of_b = neighbours(b);
  std::vector<int> common;
  std::ranges::set_intersection(of_a, of_b, std::back_inserter(common));
  if (common.size() != 2 || of_a.size() + of_b.size() < 8) return false;
  const Projected middle = projected(function_, 0.5 * (points_[a] + points_[b]), step_limit_);
  if (!may_move(a, middle, {e.left, e.right}) || !may_move(b, middle, {e.left, e.right})) return false;
  if (std::max(longest_edge_after_move(a, middle.point), longest_edge_after_move(b, middle.point)) >
      longest_allowed)
    return false;
  for (int f : {e.left, e.right}) {
    for (int v : faces_[f]) detach(f, v);
    faces_[f] = {-1, -1, -1};
  }
  for (int f : std::vector<int>(star_[b])) replace_corner(f, b, a);
  star_[b].clear();
  points_[a] = middle.point;
  normals_[a] = middle.normal;
  --vertex_count_;
  return true;
}

bool ImplicitRemesher::split(int a, int b) {
  const EdgeFaces e = edge_faces(a, b);
  if (e.left < 0 || e.right < 0) return false;
  const Projected middle = projected(function_, 0.5 * (points_[a] + points_[b]), step_limit_);
  const Vec3 &pa = points_[a], &pb = points_[b], &pc = points_[e.above], &pd = points_[e.below];
  const Vec3 n = middle.normal + normals_[a] + normals_[b];
  if (!faces_outward(pa, middle.point, pc, n) || !faces_outward(middle.point, pb, pc, n) ||
      !faces_outward(pb, middle.point, pd, n) || !faces_outward(middle.point, pa, pd, n))
    return false;
  const int m = static_cast<int>(points_.size());
  points_.push_back(middle.point);
  normals_.push_back(middle.normal);
  star_.emplace_back();
  // The old faces keep a; two new faces get b.
  for (const auto& [face, apex, ahead] :
       {std::tuple(e.left, e.above, true), std::tuple(e.right, e.below, false)}) {
    detach(face, b);
    replace_corner(face, b, m);
    const int added = static_cast<int>(faces_.size());
    faces_.push_back(ahead ? Triangle{m, b, apex} : Triangle{b, m, apex});
    for (int v : {m, b, apex}) star_[v].push_back(added);
  }
  ++vertex_count_;
  return true;
}

bool ImplicitRemesher::flip(int a, int b) {
  const EdgeFaces e = edge_faces(a, b);
  if (e.left < 0 || e.right < 0) return false;
  const int c = e.above, d = e.below;
  if (c == d || adjacent(c, d)) return false;
  if (static_cast<int>(star_[a].size()) <= least_valence ||
      static_cast<int>(star_[b].size()) <= least_valence)
    return false;
  const Vec3 &pa = points_[a], &pb = points_[b], &pc = points_[c], &pd = points_[d];
  const Vec3 around = normals_[c] + normals_[d];
  if (!faces_outward(pc, pa, pd, around + normals_[a]) || !faces_outward(pd, pb, pc, around + normals_[b]))
    return false;
  detach(e.left, b);
  detach(e.right, a);
  faces_[e.left] = {c, a, d};
  faces_[e.right] = {d, b, c};
  star_[d].push_back(e.left);
  star_[c].push_back(e.right);
  return true;
}

void ImplicitRemesher::flip_all() {
  constexpr double tie = 1e-9;  // both diagonals of a rectangle are equally good
  for (const Edge& edge : edges(0, std::numeric_limits<double>::infinity())) {
    const EdgeFaces e = edge_faces(edge.a, edge.b);
    if (e.left < 0 || e.right < 0) continue;
    const Vec3 &a = points_[edge.a], &b = points_[edge.b];
    // Delaunay condition: the angles opposite to the edge sum to at most pi.
    if (cotangent(points_[e.above], a, b) + cotangent(points_[e.below], a, b) < -tie) flip(edge.a, edge.b);
  }
}

void ImplicitRemesher::smooth_all() {
  for (std::size_t v = 0; v < points_.size(); ++v) {
    if (star_[v].empty()) continue;
    Vec3 sum = Vec3::Zero();
    double weight = 0;
    for (int f : star_[v]) {
      const Triangle& t = faces_[f];
      const std::array<Vec3, 3> p{points_[t[0]], points_[t[1]], points_[t[2]]};
      const double a = foramen::area(p);
      sum += a / 3 * (p[0] + p[1] + p[2]);
      weight += a;
    }
    if (!(weight > 0)) continue;
    const Vec3 towards = sum / weight - points_[v];
    const Vec3 tangential = towards - towards.dot(normals_[v]) * normals_[v];
    const Projected to = projected(function_, points_[v] + smoothing_step * tangential, step_limit_);
    if (!may_move(static_cast<int>(v), to, {-1, -1})) continue;
    points_[v] = to.point;
    normals_[v] = to.normal;
  }
}

void ImplicitRemesher::polish() {
  flip_all();
  smooth_all();
}

void ImplicitRemesher::equalise(double edge_length) {
  std::vector<Edge> too_long = edges(split_ratio * edge_length, std::numeric_limits<double>::infinity());
  std::ranges::sort(too_long, std::greater{});
  for (const Edge& e : too_long) split(e.a, e.b);
  std::vector<Edge> too_short = edges(0, collapse_ratio * edge_length);
  std::ranges::sort(too_short);
  for (const Edge& e : too_short) {
    if (alive(e.a) && alive(e.b) && length(e.a, e.b) < collapse_ratio * edge_length)
      collapse(e.a, e.b, split_ratio * edge_length);
  }
  polish();
}

void ImplicitRemesher::adjust_vertex_count(int target) {
  const double anything = std::numeric_limits<double>::infinity();
  bool progress = true;
  while (vertex_count_ != target && progress) {
    progress = false;
    // Edges are processed in batches, because lengths change as edges are removed or split.
    constexpr int smallest_batch = 20;
    const int missing = std::abs(vertex_count_ - target);
    const int batch = std::min(missing, std::max(smallest_batch, missing / 3));
    int done = 0;
    std::vector<Edge> all = edges(0, anything);
    std::ranges::sort(all);
    if (vertex_count_ > target) {
      for (auto e = all.begin(); e != all.end() && done < batch; ++e)
        if (alive(e->a) && alive(e->b) && collapse(e->a, e->b, anything)) ++done;
    } else {
      for (auto e = all.rbegin(); e != all.rend() && done < batch; ++e)
        if (split(e->a, e->b)) ++done;
    }
    progress = done > 0;
  }
}

}  // namespace foramen::synth
