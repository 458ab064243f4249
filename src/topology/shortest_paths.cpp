#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

ShortestPaths shortest_paths(const Mesh& mesh, VertexId source, const EdgeMap<double>& weights) {
  if (!mesh.is_closed())
    throw TopologyError("shortest paths along halfedges need a closed surface, found one with boundary");
  ShortestPaths paths{VertexMap<double>(mesh.vertex_count(), std::numeric_limits<double>::infinity()),
                      VertexMap<HalfedgeId>(mesh.vertex_count())};
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  const auto improve = [&](VertexId v, double d, HalfedgeId parent) {
    if (d >= paths.distance[v]) return;
    paths.distance[v] = d;
    paths.parent[v] = parent;
    queue.emplace(d, v);
  };
  improve(source, 0, HalfedgeId());
  while (!queue.empty()) {
    const auto [d, v] = queue.top();
    queue.pop();
    if (d > paths.distance[v]) continue;
    const HalfedgeId first = mesh.outgoing(v);
    HalfedgeId h = first;
    do {
      improve(mesh.to(h), d + weights[mesh.edge(h)], h);
      h = mesh.rotated(h);
    } while (h != first);
  }
  return paths;
}

std::vector<HalfedgeId> path_to(const Mesh& mesh, const ShortestPaths& paths, VertexId v) {
  std::vector<HalfedgeId> walk;
  for (HalfedgeId h = paths.parent[v]; h.valid(); h = paths.parent[mesh.from(h)]) walk.push_back(h);
  std::reverse(walk.begin(), walk.end());
  return walk;
}

}  // namespace foramen
