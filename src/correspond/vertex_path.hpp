#pragma once

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// Shortest paths between vertices that are close to each other, by Dijkstra's algorithm with an early stop
/// at the target. The working memory is reused by later queries.
class VertexPaths {
 public:
  VertexPaths(const Mesh& mesh, const EdgeMap<double>& lengths);
  /// The walk from a to b; empty if a == b. \pre connected
  std::vector<HalfedgeId> between(VertexId a, VertexId b);

 private:
  Mesh mesh_;
  const EdgeMap<double>& lengths_;
  VertexMap<double> distance_;
  VertexMap<HalfedgeId> parent_;
};

}  // namespace foramen
