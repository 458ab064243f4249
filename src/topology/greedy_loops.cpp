#include <algorithm>

#include "foramen/core/error.hpp"
#include "foramen/topology/shortest_loops.hpp"
#include "topology/loop_graph.hpp"

namespace foramen {
namespace {

using topology_detail::LoopGraph;
using topology_detail::LoopScratch;
using topology_detail::position_less;

// The path in the tree from the root to v.
std::vector<HalfedgeId> tree_path(const Mesh& mesh, const VertexMap<HalfedgeId>& parent, VertexId v) {
  std::vector<HalfedgeId> path;
  for (HalfedgeId h = parent[v]; h.valid(); h = parent[mesh.from(h)]) path.push_back(h);
  std::reverse(path.begin(), path.end());
  return path;
}

EdgeLoop close_loop(const Mesh& mesh, const VertexMap<HalfedgeId>& parent, HalfedgeId generator) {
  EdgeLoop loop = tree_path(mesh, parent, mesh.from(generator));
  loop.push_back(generator);
  const auto back = tree_path(mesh, parent, mesh.to(generator));
  for (auto h = back.rbegin(); h != back.rend(); ++h) loop.push_back(mesh.twin(*h));
  return loop;
}

// The direction in which a loop traverses its generator. It depends on positions, not on the numbering.
HalfedgeId directed(const Mesh& mesh, EdgeId e) {
  const HalfedgeId h = mesh.halfedge(e);
  return position_less(mesh, mesh.from(h), mesh.to(h)) ? h : mesh.twin(h);
}

}  // namespace

double loop_length(const Mesh& mesh, const EdgeLoop& loop, const EdgeMap<double>& weights) {
  double sum = 0;
  for (HalfedgeId h : loop) sum += weights[mesh.edge(h)];
  return sum;
}

LoopSystem greedy_loops(const Mesh& mesh, VertexId basepoint, const EdgeMap<double>& weights) {
  const LoopGraph graph(mesh, weights);
  FORAMEN_ASSERT(basepoint.valid() && basepoint.index < mesh.vertex_count());
  LoopScratch s = graph.scratch();
  graph.grow_tree(basepoint.index, s);
  graph.choose_parents_by_position(s);
  graph.find_leftover(s);

  LoopSystem system;
  system.basepoint = basepoint;
  system.tree_parent = VertexMap<HalfedgeId>(mesh.vertex_count());
  for (VertexId v : mesh.vertices()) system.tree_parent[v] = HalfedgeId(s.parent[v.index]);
  for (std::size_t k = 0; k < s.leftover.size(); ++k) {
    system.generators.push_back(directed(mesh, EdgeId(s.leftover[k])));
    system.loops.push_back(close_loop(mesh, system.tree_parent, system.generators.back()));
    system.length += s.loop_lengths[k];
  }
  return system;
}

}  // namespace foramen
