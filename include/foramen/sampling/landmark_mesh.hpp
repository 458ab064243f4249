#pragma once
/// \file
/// The triangles that all shapes share.

#include <array>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A triangulation of the torus whose vertices are landmarks.
struct LandmarkMesh {
  std::vector<Vec2> turns;  ///< of each landmark
  std::vector<std::array<int, 3>> triangles;
  HalfedgeMap<Vec2i> jumps;  ///< of halfedge 3f+k: an embedding of the torus like any torus map
};

}  // namespace foramen
