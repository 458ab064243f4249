#include "topology/loop_graph.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "foramen/core/error.hpp"

namespace foramen::topology_detail {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
// Width of a bucket of the queue, in mean edge weights. It affects the speed only.
constexpr double bucket_width = 0.25;
// Expansions per vertex after which the buckets become heaps; 1.1 expansions per vertex are usual. It affects
// the speed only.
constexpr std::int64_t expansions_before_heap = 3;
// Bounds the number of buckets if one weight is much larger than the mean.
constexpr double most_buckets = 4096;

int leader_of(std::vector<int>& leader, int f) {
  while (leader[f] != f) {
    leader[f] = leader[leader[f]];
    f = leader[f];
  }
  return f;
}

void check(const Mesh& mesh, const EdgeMap<double>& weights) {
  if (mesh.vertex_count() == 0) throw TopologyError("a system of loops needs a surface, found none");
  if (!mesh.is_closed())
    throw TopologyError(
        "a system of loops needs a closed surface, found one with boundary: fill its holes first");
  FORAMEN_ASSERT(weights.size() == mesh.edge_count());
  for (EdgeId e : mesh.edges())
    if (!(weights[e] >= 0 && weights[e] < infinite))
      throw InvalidInput("edge " + std::to_string(e.index) + " has the weight " + std::to_string(weights[e]) +
                         ", needs a finite one that is not negative");
}

}  // namespace

bool position_less(const Mesh& mesh, VertexId a, VertexId b) {
  const Vec3 &p = mesh.position(a), &q = mesh.position(b);
  for (int k = 0; k < 3; ++k)
    if (p[k] != q[k]) return p[k] < q[k];
  return a < b;
}

LoopGraph::LoopGraph(const Mesh& mesh, const EdgeMap<double>& weights) : mesh_(mesh) {
  check(mesh, weights);
  weight_ = weights.values();
  std::vector<int> degree(mesh.vertex_count(), 0);
  for (HalfedgeId h : mesh.halfedges()) {
    face_across_.push_back(Mesh::face(mesh.twin(h)).index);
    ++degree[mesh.from(h).index];
  }
  first_arc_.resize(degree.size() + 1, 0);
  std::partial_sum(degree.begin(), degree.end(), first_arc_.begin() + 1);
  arcs_.resize(mesh.halfedge_count());
  std::vector<int> next_arc(first_arc_.begin(), first_arc_.end() - 1);
  for (HalfedgeId h : mesh.halfedges())
    arcs_[next_arc[mesh.from(h).index]++] = {mesh.to(h).index, h.index, weights[mesh.edge(h)]};
  for (FaceId f : mesh.faces()) {
    int neighbours = 0;
    for (int k = 0; k < 3; ++k) neighbours ^= face_across_[3 * f.index + k];
    whole_faces_.push_back({3, neighbours});
  }
  for (EdgeId e : mesh.edges()) {
    const HalfedgeId h = mesh.halfedge(e);
    edge_vertices_.push_back({mesh.from(h).index, mesh.to(h).index});
  }

  const double largest = *std::max_element(weight_.begin(), weight_.end());
  const double mean =
      std::accumulate(weight_.begin(), weight_.end(), 0.0) / static_cast<double>(weight_.size());
  const double width = std::max(bucket_width * mean, largest / most_buckets);
  if (width > 0 && 1 / width < infinite) buckets_per_length_ = 1 / width;
  // A step spans at most this many buckets, plus one for the fraction of a bucket, one for rounding and one
  // for the bucket in which it starts.
  bucket_count_ = std::bit_ceil(static_cast<std::size_t>(largest * buckets_per_length_) + 3);

  LoopScratch s = scratch();
  grow_tree(0, s);
  const auto lost = std::find(s.distance.begin(), s.distance.end(), infinite);
  if (lost != s.distance.end())
    throw TopologyError("a system of loops needs a connected surface: vertex " +
                        std::to_string(lost - s.distance.begin()) + " cannot be reached from vertex 0");
  loop_count_ = 2 - mesh.euler_characteristic();
}

LoopScratch LoopGraph::scratch() const {
  LoopScratch s;
  s.distance.resize(vertex_count());
  s.parent.resize(vertex_count());
  s.buckets.resize(bucket_count_);
  s.faces.resize(mesh_.face_count());
  s.leader.resize(mesh_.face_count());
  return s;
}

void LoopGraph::evaluate(int basepoint, LoopScratch& s) const {
  grow_tree(basepoint, s);
  find_leftover(s);
}

// Dijkstra's algorithm with a bucket queue. The order within a bucket is arbitrary, and a vertex whose
// distance improves after its expansion is expanded again. For edge lengths of a surface this is rare, and
// the search is twice as fast as with a heap. If weights differ so much that repeated expansions are
// frequent, the rest of the search keeps the current bucket as a heap, which bounds the run time for any
// weights. The distances are the exact minima, over all walks, of the floating-point sums from the basepoint
// outward, so they do not depend on the order. Only strict improvements change a parent, so the parents form
// a tree.
void LoopGraph::grow_tree(int basepoint, LoopScratch& s) const {
  std::fill(s.distance.begin(), s.distance.end(), infinite);
  std::fill(s.parent.begin(), s.parent.end(), -1);
  const auto later = [](const LoopScratch::Entry& a, const LoopScratch::Entry& b) {
    return a.distance > b.distance;
  };
  const std::size_t mask = bucket_count_ - 1;
  const std::int64_t free_expansions = expansions_before_heap * std::int64_t(vertex_count());
  std::int64_t expansions = 0;
  bool ordered = false;
  s.distance[basepoint] = 0;
  s.buckets[0].push_back({0, basepoint});
  std::size_t waiting = 1;
  for (std::size_t current = 0; waiting > 0; ++current) {
    auto& bucket = s.buckets[current & mask];
    if (ordered) std::make_heap(bucket.begin(), bucket.end(), later);
    while (!bucket.empty()) {
      if (ordered) std::pop_heap(bucket.begin(), bucket.end(), later);
      const LoopScratch::Entry entry = bucket.back();
      bucket.pop_back();
      --waiting;
      // Outdated: the vertex was reached by a shorter path.
      if (entry.distance != s.distance[entry.vertex]) continue;
      for (int k = first_arc_[entry.vertex]; k < first_arc_[entry.vertex + 1]; ++k) {
        const Arc& arc = arcs_[k];
        const double d = entry.distance + arc.weight;
        if (d >= s.distance[arc.to]) continue;
        s.distance[arc.to] = d;
        s.parent[arc.to] = arc.halfedge;
        const std::size_t index = static_cast<std::size_t>(d * buckets_per_length_);
        auto& target = s.buckets[index & mask];
        target.push_back({d, arc.to});
        if (ordered && index == current) std::push_heap(target.begin(), target.end(), later);
        ++waiting;
      }
      if (++expansions == free_expansions) {
        ordered = true;
        std::make_heap(bucket.begin(), bucket.end(), later);
      }
    }
  }
}

void LoopGraph::choose_parents_by_position(LoopScratch& s) const {
  for (int v = 0; v < vertex_count(); ++v) {
    int best = -1, best_from = -1;
    for (int k = first_arc_[v]; k < first_arc_[v + 1]; ++k) {
      const Arc& arc = arcs_[k];
      const double d = s.distance[arc.to];
      // A parent must be strictly nearer to the basepoint, because with zero weights two vertices could
      // otherwise become parents of each other.
      if (d >= s.distance[v] || d + arc.weight != s.distance[v]) continue;
      if (best < 0 || position_less(mesh_, VertexId(arc.to), VertexId(best_from))) {
        best = mesh_.twin(HalfedgeId(arc.halfedge)).index;
        best_from = arc.to;
      }
    }
    if (best >= 0) s.parent[v] = best;
  }
}

double LoopGraph::loop_length(int edge, const std::vector<double>& distance) const {
  const auto& ends = edge_vertices_[edge];
  return (distance[ends[0]] + distance[ends[1]]) + weight_[edge];
}

// Every spanning tree of the dual graph contains its bridges, so leaves of the dual graph can be removed
// first, in linear time and without their lengths. The rest, called the core, is the part of the cut locus
// that carries the topology. It has a few hundred edges at most, so it is cheap to sort.
void LoopGraph::peel(LoopScratch& s) const {
  s.faces = whole_faces_;
  const auto part = [&](int f, int g) {
    LoopScratch::FaceState& face = s.faces[f];
    face.neighbours ^= g;
    return --face.degree;
  };
  for (int h : s.parent) {
    if (h < 0) continue;
    const int f = h / 3, g = face_across_[h];
    part(f, g);
    part(g, f);
  }
  s.stack.clear();
  for (std::size_t f = 0; f < s.faces.size(); ++f)
    if (s.faces[f].degree == 1) s.stack.push_back(static_cast<int>(f));
  while (!s.stack.empty()) {
    const int f = s.stack.back();
    s.stack.pop_back();
    if (s.faces[f].degree == 0) continue;  // the last face of a sphere
    const int g = s.faces[f].neighbours;
    s.faces[f].degree = 0;
    if (part(g, f) == 1) s.stack.push_back(g);
  }
}

bool LoopGraph::in_tree(HalfedgeId h, const LoopScratch& s) const {
  return s.parent[mesh_.to(h).index] == h.index || s.parent[mesh_.from(h).index] == mesh_.twin(h).index;
}

// Collects the dual edges between remaining faces; none of them was removed by peel().
void LoopGraph::collect_core(LoopScratch& s) const {
  s.core.clear();
  for (std::size_t f = 0; f < s.faces.size(); ++f) {
    if (s.faces[f].degree == 0) continue;
    s.leader[f] = static_cast<int>(f);
    for (int k = 0; k < 3; ++k) {
      const HalfedgeId h(3 * static_cast<int>(f) + k);
      const int across = face_across_[h.index];
      if (across > static_cast<int>(f) && s.faces[across].degree > 0 && !in_tree(h, s))
        s.core.push_back(mesh_.edge(h).index);
    }
  }
}

void LoopGraph::find_leftover(LoopScratch& s) const {
  peel(s);
  collect_core(s);
  const auto edge_less = [&](int a, int b) {  // only for ties
    auto p = edge_vertices_[a], q = edge_vertices_[b];
    for (auto* ends : {&p, &q})
      if (position_less(mesh_, VertexId((*ends)[1]), VertexId((*ends)[0]))) std::swap((*ends)[0], (*ends)[1]);
    for (std::size_t k = 0; k < 2; ++k)
      if (p[k] != q[k]) return position_less(mesh_, VertexId(p[k]), VertexId(q[k]));
    return a < b;
  };
  std::sort(s.core.begin(), s.core.end(), [&](int a, int b) {  // the longest loops first
    const double la = loop_length(a, s.distance), lb = loop_length(b, s.distance);
    return la != lb ? la > lb : edge_less(b, a);
  });
  s.leftover.clear();
  for (int e : s.core) {
    const HalfedgeId h = mesh_.halfedge(EdgeId(e));
    const int a = leader_of(s.leader, Mesh::face(h).index), b = leader_of(s.leader, face_across_[h.index]);
    if (a == b)
      s.leftover.push_back(e);
    else
      s.leader[a] = b;
  }
  std::reverse(s.leftover.begin(), s.leftover.end());
  FORAMEN_ASSERT(static_cast<int>(s.leftover.size()) == loop_count_);
  s.loop_lengths.clear();
  for (int e : s.leftover) s.loop_lengths.push_back(loop_length(e, s.distance));
}

}  // namespace foramen::topology_detail
