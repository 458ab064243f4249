#pragma once
// Moving some vertices of a mesh so that the surface is smooth there.

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

enum class Fairness {
  membrane,   ///< every free vertex in the middle of its neighbours: the flattest, with a crease at the rim
  thin_plate  ///< least sum of squares of (middle of the neighbours - vertex): continues the surface round it
};

/// Positions of all vertices when the free ones are moved. The fixed neighbours of the free ones shape them.
/// \cite kobbelt1998
std::vector<Vec3> faired(const Mesh& mesh, const std::vector<VertexId>& free, Fairness fairness);

}  // namespace foramen::repair_detail
