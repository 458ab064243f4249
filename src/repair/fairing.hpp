#pragma once
// Fairing: moves some vertices of a mesh so that the surface is smooth there.

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

enum class Fairness {
  /// Every free vertex is the mean of its neighbours: flat, with a crease at the border of the free part.
  membrane,
  /// Least sum of |mean of the neighbours - vertex|^2 over free vertices and their neighbours: continues the
  /// surrounding surface smoothly.
  thin_plate
};

/// Returns the positions of all vertices. Only the `free` ones are moved; their fixed neighbours are the
/// boundary condition \cite kobbelt1998. If the linear system cannot be solved, all positions are unchanged.
std::vector<Vec3> faired(const Mesh& mesh, const std::vector<VertexId>& free, Fairness fairness);

}  // namespace foramen::repair_detail
