#include "foramen/topology/handle_loops.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "topology/lifted_loop.hpp"
#include "topology/linking.hpp"

namespace foramen {
namespace {

using namespace topology_detail;

// Linking numbers of a loop with each loop of a basis. In each pair the second loop is pushed outward off the
// surface.
struct Links {
  std::vector<int> with_lifted, lifted_with;  // lk(loop, l+), lk(l, loop+)
  friend bool operator==(const Links&, const Links&) = default;
};

// nullopt if a number is not an integer, or if the two numbers of a pair do not differ by the intersection
// number of the loops.
std::optional<Links> links(const Mesh& mesh, const EdgeLoop& loop, const std::vector<EdgeLoop>& basis,
                           double push) {
  const auto polygon = positions_of(mesh, loop);
  const auto lifted = pushed_outward(mesh, crossings_left_of(mesh, loop), push);
  Links found;
  for (const EdgeLoop& other : basis) {
    const auto above =
        nearest_integer(gauss_integral(polygon, pushed_outward(mesh, crossings_left_of(mesh, other), push)));
    const auto below = nearest_integer(gauss_integral(positions_of(mesh, other), lifted));
    if (!above || !below || *above - *below != -intersection_number(mesh, loop, other)) return std::nullopt;
    found.with_lifted.push_back(*above);
    found.lifted_with.push_back(*below);
  }
  return found;
}

bool all_zero(const std::vector<int>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](int n) { return n == 0; });
}

// The double cover of the surface whose sheets are exchanged across the loop. A closed walk that crosses the
// loop an odd number of times is a path from a vertex to the same vertex on the other sheet.
class DoubleCover {
 public:
  DoubleCover(const Mesh& mesh, const EdgeLoop& loop, const EdgeMap<double>& lengths)
      : mesh_(mesh), lengths_(lengths), crosses_(mesh.edge_count(), 0) {
    for (HalfedgeId h : crossings_left_of(mesh, loop)) crosses_[mesh.edge(h)] ^= 1;
    for (auto& d : distance_) d = VertexMap<double>(mesh.vertex_count(), infinite);
    for (auto& p : parent_) p = VertexMap<HalfedgeId>(mesh.vertex_count());
  }

  /// The shortest such walk through `source`; empty if there is none shorter than `bound`. This is a
  /// bidirectional search: by the symmetry of the sheets one search also gives the distances from the other
  /// end of the path, so it stops at half the length of the best path.
  EdgeLoop shortest_through(VertexId source, double bound) {
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    double best = bound;
    VertexId meeting;
    const auto improve = [&](VertexId v, int sheet, double d, HalfedgeId parent) {
      double &here = distance_[at(sheet)][v], other = distance_[at(1 - sheet)][v];
      if (d >= here) return;
      if (here == infinite) reached_.emplace_back(v, sheet);
      here = d;
      parent_[at(sheet)][v] = parent;
      queue.emplace(d, v, sheet);
      if (d + other < best) {
        best = d + other;
        meeting = v;
      }
    };
    improve(source, 0, 0, HalfedgeId());
    while (!queue.empty()) {
      const auto [d, v, sheet] = queue.top();
      queue.pop();
      if (2 * d >= best) break;
      if (d > distance_[at(sheet)][v]) continue;
      for (HalfedgeId h : mesh_.fan(v))
        improve(mesh_.to(h), sheet ^ crosses_[mesh_.edge(h)], d + lengths_[mesh_.edge(h)], h);
    }
    EdgeLoop loop;
    if (meeting.valid()) {
      loop = path_to(meeting, 0);
      const EdgeLoop back = path_to(meeting, 1);
      for (auto h = back.rbegin(); h != back.rend(); ++h) loop.push_back(mesh_.twin(*h));
    }
    forget();
    return loop;
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();
  using Entry = std::tuple<double, VertexId, int>;
  static std::size_t at(int sheet) { return sheet; }

  EdgeLoop path_to(VertexId v, int sheet) const {
    EdgeLoop path;
    for (HalfedgeId h = parent_[at(sheet)][v]; h.valid(); h = parent_[at(sheet)][v]) {
      path.push_back(h);
      v = mesh_.from(h);
      sheet ^= crosses_[mesh_.edge(h)];
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  void forget() {
    for (const auto& [v, sheet] : reached_) {
      distance_[at(sheet)][v] = infinite;
      parent_[at(sheet)][v] = HalfedgeId();
    }
    reached_.clear();
  }

  const Mesh& mesh_;
  const EdgeMap<double>& lengths_;
  EdgeMap<int> crosses_;  // 0 or 1
  std::array<VertexMap<double>, 2> distance_;
  std::array<VertexMap<HalfedgeId>, 2> parent_;
  std::vector<std::pair<VertexId, int>> reached_;
};

}  // namespace

LoopKind loop_kind(const Mesh& mesh, const EdgeLoop& loop) {
  if (loop.empty()) throw InvalidInput("a loop without edges bounds on no side");
  const LoopSystem basis = greedy_loops(mesh, mesh.from(loop.front()), edge_lengths(mesh));
  std::optional<Links> previous;
  for (double push : pushes) {
    const auto now = links(mesh, loop, basis.loops, push);
    if (now && now == previous) {
      if (all_zero(now->lifted_with)) return LoopKind::tunnel;
      return all_zero(now->with_lifted) ? LoopKind::handle : LoopKind::neither;
    }
    previous = now;
  }
  throw ConvergenceError(
      "the linking numbers of a loop do not settle: the surface may intersect itself near the loop");
}

EdgeLoop shortest_crossing_loop(const Mesh& mesh, const EdgeLoop& loop, const EdgeMap<double>& lengths) {
  DoubleCover cover(mesh, loop, lengths);
  // A walk that crosses the loop has a vertex on it. For two vertices of the loop at a distance d along it,
  // the lengths of the shortest crossing walks through them differ by at most 2 d. The search goes through
  // the vertices of the loop in the order of the lower bound that this gives.
  std::vector<double> along{0}, bound(loop.size(), 0);
  for (HalfedgeId h : loop) along.push_back(along.back() + lengths[mesh.edge(h)]);
  EdgeLoop shortest;
  double length = std::numeric_limits<double>::infinity();
  for (std::size_t tries = 0; tries < loop.size(); ++tries) {
    const std::size_t next = std::min_element(bound.begin(), bound.end()) - bound.begin();
    if (bound[next] >= length) break;
    EdgeLoop found = cover.shortest_through(mesh.from(loop[next]), length);
    if (!found.empty()) {
      length = loop_length(mesh, found, lengths);
      shortest = std::move(found);
    }
    // The walk through this vertex has at least the length `length`, which bounds all other vertices from
    // below.
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double direct = std::abs(along[i] - along[next]);
      bound[i] = std::max(bound[i], length - 2 * std::min(direct, along.back() - direct));
    }
    bound[next] = std::numeric_limits<double>::infinity();
  }
  if (shortest.empty()) throw TopologyError("no loop crosses one that is homologous to zero");
  return shortest;
}

}  // namespace foramen
