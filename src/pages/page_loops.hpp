#pragma once

#include <array>
#include <string>
#include <vector>

#include "foramen/core/surface_point.hpp"
#include "modelfiles/atlas_file.hpp"

namespace foramen {

/// The template's loops on the landmark mesh: the points that have their torus positions. So they can be
/// drawn on every shape of the model.
std::array<std::vector<SurfacePoint>, 2> loops_on_landmarks(const Atlas& atlas);

/// Where to look at a model from, in its coordinates.
struct PageView {
  std::string name;
  Vec3 from;  ///< unit vector from the model to the eye
  Vec3 up;    ///< unit vector, orthogonal to it
};

/// Views along the canal, whose axis is normal to the loop around it; if none or both of the loops run around
/// it, along the principal axes. The axis points to the head where the input's third coordinate (S in LPS and
/// RAS) says so.
std::vector<PageView> page_views(const Mesh& mean, const std::array<std::vector<SurfacePoint>, 2>& loops);

}  // namespace foramen
