#pragma once
/// \file
/// Positions on the torus that are averages of their neighbours.

#include <optional>

#include "foramen/parameterize/torus_map.hpp"
#include "topology/periods.hpp"

namespace foramen {

/// Solves sum_j (p_j + t_ij - p_i) = 0 at every vertex i that is not fixed. \pre at least one vertex is fixed
VertexMap<Vec2> average_of_neighbours(const Mesh& mesh, const Cocycle& form,
                                      const VertexMap<std::optional<Vec2>>& fixed);

/// Throws TopologyError unless the map has degree 1, that is, its periods are a positively oriented basis.
/// Throws ConvergenceError if the area of a triangle is not positive.
void check_embedding(const Mesh& mesh, const TorusMap& map);

}  // namespace foramen
