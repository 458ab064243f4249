#pragma once
/// \file
/// The triangles that all shapes share.

#include <array>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A triangulation of the torus whose vertices are landmarks.
struct LandmarkMesh {
  std::vector<Vec2> turns;  ///< torus position of each landmark
  std::vector<std::array<int, 3>> triangles;
  HalfedgeMap<Vec2i> jumps;  ///< of halfedge 3f+k, as in TorusMap
};

}  // namespace foramen
