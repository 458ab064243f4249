#include "correspond/vertex_path.hpp"

#include <algorithm>
#include <limits>
#include <queue>
#include <utility>

#include "foramen/core/error.hpp"

namespace foramen {

VertexPaths::VertexPaths(const Mesh& mesh, const EdgeMap<double>& lengths)
    : mesh_(mesh),
      lengths_(lengths),
      distance_(mesh.vertex_count(), std::numeric_limits<double>::infinity()),
      parent_(mesh.vertex_count()) {}

std::vector<HalfedgeId> VertexPaths::between(VertexId a, VertexId b) {
  using Entry = std::pair<double, VertexId>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  std::vector<VertexId> touched{a};
  distance_[a] = 0;
  open.emplace(0.0, a);
  while (!open.empty() && open.top().second != b) {
    const auto [d, v] = open.top();
    open.pop();
    if (d > distance_[v]) continue;
    for (HalfedgeId h : mesh_.fan(v)) {
      const VertexId w = mesh_.to(h);
      const double through = d + lengths_[mesh_.edge(h)];
      if (through >= distance_[w]) continue;
      if (distance_[w] == std::numeric_limits<double>::infinity()) touched.push_back(w);
      distance_[w] = through;
      parent_[w] = h;
      open.emplace(through, w);
    }
  }
  FORAMEN_ASSERT(!open.empty());
  std::vector<HalfedgeId> walk;
  for (VertexId v = b; v != a; v = mesh_.from(parent_[v])) walk.push_back(parent_[v]);
  std::reverse(walk.begin(), walk.end());
  for (VertexId v : touched) distance_[v] = std::numeric_limits<double>::infinity();
  return walk;
}

}  // namespace foramen
