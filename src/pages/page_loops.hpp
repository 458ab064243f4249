#pragma once

#include <array>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "modelfiles/atlas.hpp"

namespace foramen {

/// The template's loops on the landmark mesh: the points of the mesh with the torus positions of the loops.
/// These points exist on every shape of the model, so the loops can be drawn on every shape.
std::array<std::vector<SurfacePoint>, 2> loops_on_landmarks(const Atlas& atlas);

/// A direction of view, in the model's coordinates.
struct PageView {
  std::string name;
  Vec3 from;  ///< unit vector from the model to the eye
  Vec3 up;    ///< unit vector, orthogonal to it
};

/// Views relative to the canal, whose axis is normal to the loop around it. If none or both of the loops seem
/// to run around the canal, the views are along the principal axes. The axis is directed towards positive
/// third coordinates of the input, which is the direction to the head in LPS and RAS.
std::vector<PageView> page_views(const Mesh& mean, const std::array<std::vector<SurfacePoint>, 2>& loops);

}  // namespace foramen
