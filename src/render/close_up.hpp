#pragma once
/// \file
/// Where to look to see the marked triangles of a surface.

#include <vector>

#include "render/render_scene.hpp"

namespace foramen {

struct CloseUpOptions {
  double size_mm = 30;    ///< width and height of the picture
  double pixel_mm = 0.5;  ///< of the depth images from which the camera is chosen. > 0.
  int directions = 60;    ///< that are tried, spread evenly over the sphere
};

/// The close-up with most of its picture covered by marked triangles that nothing hides: by depth images from
/// all directions; of equal ones the first. \pre at least one triangle is marked.
Camera close_up(const TriangleSoup& surface, const std::vector<int>& marked,
                const CloseUpOptions& options = {});

}  // namespace foramen
