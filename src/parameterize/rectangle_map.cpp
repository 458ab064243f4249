#include <algorithm>
#include <string>
#include <vector>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "parameterize/initial_map.hpp"
#include "parameterize/periodic_laplacian.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

/// A side of the domain: a walk along edges between vertices at which sides meet.
using Arc = std::vector<HalfedgeId>;

// The graph of the loop edges without spurs. A spur ends at a vertex that has no other loop edge.
class CutGraph {
 public:
  CutGraph(const Mesh& mesh, const LoopSystem& loops)
      : mesh_(mesh), is_cut_(mesh.edge_count(), 0), degree_(mesh.vertex_count(), 0) {
    for (const EdgeLoop& loop : loops.loops)
      for (HalfedgeId h : loop) is_cut_[mesh.edge(h)] = 1;
    for (EdgeId e : mesh.edges())
      if (is_cut_[e]) add_degree(mesh.halfedge(e), 1);
    for (const EdgeLoop& loop : loops.loops)
      for (HalfedgeId h : loop) {
        prune_from(mesh.from(h));
        prune_from(mesh.to(h));
      }
  }

  std::vector<VertexId> branchings() const {
    std::vector<VertexId> out;
    for (VertexId v : mesh_.vertices())
      if (degree_[v] > 2) out.push_back(v);
    return out;
  }

  // All arcs that start at v, each up to the next branching vertex.
  std::vector<Arc> arcs_from(VertexId v) const {
    std::vector<Arc> out;
    for (HalfedgeId start : mesh_.fan(v)) {
      if (!is_cut_[mesh_.edge(start)]) continue;
      Arc arc{start};
      while (degree_[mesh_.to(arc.back())] == 2) arc.push_back(other_cut_edge(arc.back()));
      out.push_back(std::move(arc));
    }
    return out;
  }
  int degree(VertexId v) const { return degree_[v]; }

 private:
  void add_degree(HalfedgeId h, int change) {
    degree_[mesh_.from(h)] += change;
    degree_[mesh_.to(h)] += change;
  }
  void prune_from(VertexId v) {
    while (degree_[v] == 1) {
      const auto fan = mesh_.fan(v);
      const HalfedgeId last =
          *std::find_if(fan.begin(), fan.end(), [&](HalfedgeId h) { return is_cut_[mesh_.edge(h)]; });
      is_cut_[mesh_.edge(last)] = 0;
      add_degree(last, -1);
      v = mesh_.to(last);
    }
  }
  HalfedgeId other_cut_edge(HalfedgeId arrived) const {
    for (HalfedgeId h : mesh_.fan(mesh_.to(arrived)))
      if (is_cut_[mesh_.edge(h)] && h != mesh_.twin(arrived)) return h;
    FORAMEN_ASSERT(false);
    return {};
  }

  const Mesh& mesh_;
  EdgeMap<char> is_cut_;
  VertexMap<int> degree_;
};

// The sides of the domain. With one branching vertex they are two arcs from it to itself (a rectangle). With
// two they are three arcs from the first to the second (a hexagon).
std::vector<Arc> sides(const Mesh& mesh, const LoopSystem& loops) {
  const CutGraph graph(mesh, loops);
  const std::vector<VertexId> branchings = graph.branchings();
  const bool rectangle = branchings.size() == 1 && graph.degree(branchings[0]) == 4;
  const bool hexagon =
      branchings.size() == 2 && graph.degree(branchings[0]) == 3 && graph.degree(branchings[1]) == 3;
  if (!rectangle && !hexagon)
    throw TopologyError("the two loops do not cut the surface open to one disk; they branch at " +
                        std::to_string(branchings.size()) + " vertices");
  std::vector<Arc> arcs;
  for (Arc& arc : graph.arcs_from(branchings[0])) {
    const bool seen_backwards = std::any_of(
        arcs.begin(), arcs.end(), [&](const Arc& other) { return other.back() == mesh.twin(arc.front()); });
    if (!seen_backwards) arcs.push_back(std::move(arc));
  }
  return arcs;
}

// The sums of the jumps from the start of the arc to each of its vertices.
std::vector<Vec2i> sums_along(const Cocycle& form, const Arc& arc) {
  std::vector<Vec2i> sums{Vec2i::Zero()};
  for (HalfedgeId h : arc) sums.push_back(sums.back() + form.value[h]);
  return sums;
}

// Finds an edge that joins two vertices of the arc and is homotopic to the part of the arc between them, and
// replaces this part by the edge. False if there is no such edge.
bool take_a_chord(const Mesh& mesh, const Cocycle& form, Arc& arc) {
  const std::vector<Vec2i> sums = sums_along(form, arc);
  VertexMap<int> place(mesh.vertex_count(), -1);
  for (std::size_t k = 0; k < arc.size(); ++k) place[mesh.to(arc[k])] = static_cast<int>(k) + 1;
  for (int a = 0; a < static_cast<int>(arc.size()); ++a)
    for (HalfedgeId h : mesh.fan(mesh.from(arc[a]))) {
      const int b = place[mesh.to(h)];
      if (b < a + 2) continue;
      // On a torus a closed walk with zero periods is contractible.
      if (form.value[h] != sums[b] - sums[a]) continue;
      arc[a] = h;
      arc.erase(arc.begin() + a + 1, arc.begin() + b);
      return true;
    }
  return false;
}

void fix_side(const Mesh& mesh, const Cocycle& form, const Arc& arc, const Vec2& displacement,
              VertexMap<std::optional<Vec2>>& fixed) {
  const std::vector<Vec2i> sums = sums_along(form, arc);
  double length = 0;
  for (HalfedgeId h : arc) length += edge_length(mesh, mesh.edge(h));
  double walked = 0;
  for (std::size_t k = 0; k + 1 < arc.size(); ++k) {
    walked += edge_length(mesh, mesh.edge(arc[k]));
    fixed[mesh.to(arc[k])] = Vec2(displacement * (walked / length) - sums[k + 1].cast<double>());
  }
}

}  // namespace

TorusMap rectangle_torus_map(const Mesh& mesh, const LoopSystem& loops) {
  const Cocycle form = cocycle(mesh, loops);
  std::vector<Arc> arcs = sides(mesh, loops);
  for (Arc& arc : arcs)
    while (take_a_chord(mesh, form, arc)) {
    }

  // The first branching vertex is at the origin. The displacement along a side is its period, in a hexagon
  // plus the displacement to the second branching vertex. There the displacements of the three sides sum to
  // zero, which makes the hexagon convex.
  VertexMap<std::optional<Vec2>> fixed(mesh.vertex_count());
  const VertexId origin = mesh.from(arcs[0].front()), other = mesh.to(arcs[0].back());
  Vec2 between = Vec2::Zero();
  if (origin != other) {
    for (const Arc& arc : arcs) between -= sums_along(form, arc).back().cast<double>() / 3;
    fixed[other] = between;
  }
  fixed[origin] = Vec2::Zero();
  for (const Arc& arc : arcs)
    fix_side(mesh, form, arc, between + sums_along(form, arc).back().cast<double>(), fixed);
  TorusMap map{Lattice::Identity(), average_of_neighbours(mesh, form, fixed), form.value};
  check_embedding(mesh, map);
  return map;
}

}  // namespace foramen
