#include "repair/disk.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen::repair_detail {
namespace {

// An edge is split if it is longer than this many mean edges of the loop.
constexpr double longest_edge = 1.5;
// Limits of the rounds. Each refining round splits the longest edges in half, so this many suffice for any
// loop.
constexpr int refining_rounds = 12, flipping_rounds = 20;
// An edge is flipped if the sum of its opposite angles exceeds pi by more than this, so that the flips
// terminate.
constexpr double flip_margin = 1e-6;

using Triangle = std::array<int, 3>;

double angle(const Vec3& tip, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - tip, v = b - tip;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

// The triangulation of least area, by dynamic programming; empty if every triangulation needs an edge that
// exists already.
std::vector<Triangle> least_area(const std::vector<Vec3>& loop, const std::function<bool(int, int)>& joined) {
  const int n = static_cast<int>(loop.size());
  constexpr double infinite = std::numeric_limits<double>::infinity();
  std::vector<double> cost(n * n, 0);
  std::vector<int> apex(n * n, -1);
  const auto cell = [n](int i, int k) { return i * n + k; };
  for (int span = 2; span < n; ++span)
    for (int i = 0; i + span < n; ++i) {
      const int k = i + span;
      cost[cell(i, k)] = infinite;
      if (span < n - 1 && joined(i, k)) continue;
      for (int j = i + 1; j < k; ++j) {
        const double parts = cost[cell(i, j)] + cost[cell(j, k)];
        if (!(parts < cost[cell(i, k)])) continue;
        const double whole = parts + area({loop[i], loop[j], loop[k]});
        if (!(whole < cost[cell(i, k)])) continue;
        cost[cell(i, k)] = whole;
        apex[cell(i, k)] = j;
      }
    }
  std::vector<Triangle> triangles;
  std::vector<std::pair<int, int>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [i, k] = open.back();
    open.pop_back();
    if (k - i < 2) continue;
    const int j = apex[cell(i, k)];
    if (j < 0) return {};
    triangles.push_back({i, j, k});
    open.emplace_back(i, j);
    open.emplace_back(j, k);
  }
  return triangles;
}

// A disk that can be refined. Each directed edge is mapped to the triangle on its left.
class GrowingDisk {
 public:
  GrowingDisk(const std::vector<Vec3>& loop, std::vector<Triangle> triangles,
              const std::function<bool(int, int)>& joined)
      : points_(loop),
        triangles_(std::move(triangles)),
        joined_(joined),
        loop_size_(static_cast<int>(loop.size())) {
    if (triangles_.empty()) fan();
    for (std::size_t t = 0; t < triangles_.size(); ++t) enter(static_cast<int>(t));
  }

  void refine() {
    double target = 0;
    for (int i = 0; i < loop_size_; ++i) target += length(i, (i + 1) % loop_size_) / loop_size_;
    flip_all();
    for (int round = 0; round < refining_rounds && split_longer_than(longest_edge * target); ++round) {
      flip_all();
      relax();
    }
  }

  Disk disk() const { return {{points_.begin() + loop_size_, points_.end()}, triangles_}; }

 private:
  using Edge = std::pair<int, int>;

  void fan() {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : points_) sum += p;
    points_.emplace_back(sum / loop_size_);
    for (int i = 0; i < loop_size_; ++i) triangles_.push_back({i, (i + 1) % loop_size_, loop_size_});
  }

  double length(int a, int b) const { return (points_[a] - points_[b]).norm(); }

  void enter(int t) {
    for (std::size_t k = 0; k < 3; ++k) left_of_[{triangles_[t][k], triangles_[t][(k + 1) % 3]}] = t;
  }

  int tip(int t, const Edge& e) const {
    for (int corner : triangles_[t])
      if (corner != e.first && corner != e.second) return corner;
    FORAMEN_ASSERT(false);
    return -1;
  }

  // Edges between two triangles of the disk, each once.
  std::vector<Edge> inner_edges() const {
    std::vector<Edge> edges;
    for (const auto& [e, t] : left_of_)
      if (e.first < e.second && left_of_.contains({e.second, e.first})) edges.push_back(e);
    return edges;
  }

  // Splits edges longer than the limit. Returns whether there was such an edge.
  bool split_longer_than(double limit) {
    std::vector<std::pair<double, Edge>> longer;
    for (const Edge& e : inner_edges())
      if (length(e.first, e.second) > limit) longer.emplace_back(-length(e.first, e.second), e);
    std::sort(longer.begin(), longer.end());
    std::vector<char> divided(triangles_.size(), 0);
    for (const auto& [negative, e] : longer) {
      const int t = left_of_.at(e), u = left_of_.at({e.second, e.first});
      // Triangles made in this round have indices beyond `divided` and are not split again in it.
      if (std::max(t, u) >= std::ssize(divided) || divided[t] != 0 || divided[u] != 0) continue;
      divided[t] = divided[u] = 1;
      split(e, t, u);
    }
    return !longer.empty();
  }

  void split(const Edge& e, int t, int u) {
    const auto [a, b] = e;
    const int c = tip(t, e), d = tip(u, e), m = static_cast<int>(points_.size());
    points_.emplace_back((points_[a] + points_[b]) / 2);
    left_of_.erase(e);
    left_of_.erase({b, a});
    triangles_[t] = {a, m, c};
    triangles_[u] = {b, m, d};
    enter(t);
    enter(u);
    for (const Triangle& half : {Triangle{m, b, c}, Triangle{m, a, d}}) {
      triangles_.push_back(half);
      enter(static_cast<int>(triangles_.size()) - 1);
    }
  }

  void flip_all() {
    for (int round = 0; round < flipping_rounds; ++round) {
      int flips = 0;
      for (const Edge& e : inner_edges()) flips += flip(e) ? 1 : 0;
      if (flips == 0) return;
    }
  }

  bool flip(const Edge& e) {
    const auto [a, b] = e;
    const auto t = left_of_.find(e), u = left_of_.find({b, a});
    if (t == left_of_.end() || u == left_of_.end()) return false;  // an earlier flip removed the edge
    const int c = tip(t->second, e), d = tip(u->second, e);
    const auto p = [&](int i) -> const Vec3& { return points_[i]; };
    if (angle(p(c), p(a), p(b)) + angle(p(d), p(a), p(b)) <= std::numbers::pi + flip_margin) return false;
    if (c == d || left_of_.contains({c, d}) || left_of_.contains({d, c})) return false;
    if (c < loop_size_ && d < loop_size_ && joined_(c, d)) return false;
    const int first = t->second, second = u->second;
    left_of_.erase(e);
    left_of_.erase({b, a});
    triangles_[first] = {c, d, b};
    triangles_[second] = {d, c, a};
    enter(first);
    enter(second);
    return true;
  }

  // Moves inner points to the mean of their neighbours a few times. The shape of the disk is determined later
  // by fairing.
  void relax() {
    constexpr int relaxing_rounds = 3;
    for (int round = 0; round < relaxing_rounds; ++round) {
      std::vector<Vec3> sum(points_.size(), Vec3::Zero());
      std::vector<int> count(points_.size(), 0);
      for (const auto& [e, t] : left_of_) {
        sum[e.first] += points_[e.second];
        ++count[e.first];
      }
      for (std::size_t v = loop_size_; v < points_.size(); ++v) points_[v] = sum[v] / count[v];
    }
  }

  std::vector<Vec3> points_;
  std::vector<Triangle> triangles_;
  const std::function<bool(int, int)>& joined_;
  int loop_size_;
  std::map<Edge, int> left_of_;
};

}  // namespace

Disk disk_of(const std::vector<Vec3>& loop, const std::function<bool(int, int)>& joined) {
  FORAMEN_ASSERT(loop.size() >= 3 && loop.size() <= most_loop_points);
  GrowingDisk disk(loop, least_area(loop, joined), joined);
  disk.refine();
  return disk.disk();
}

}  // namespace foramen::repair_detail
