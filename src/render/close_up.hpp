#pragma once
/// \file
/// The camera that shows the marked triangles of a surface best.

#include <vector>

#include "render/render_scene.hpp"

namespace foramen {

struct CloseUpOptions {
  double size_mm = 30;    ///< width and height of the picture
  double pixel_mm = 0.5;  ///< of the depth images from which the camera is chosen. > 0.
  int directions = 60;    ///< number of directions that are tried, spread evenly over the sphere
};

/// The close-up in which visible marked triangles cover most of the picture, chosen from depth images in all
/// directions. Of equally good close-ups the first is chosen. \pre at least one triangle is marked.
Camera close_up(const TriangleSoup& surface, const std::vector<int>& marked,
                const CloseUpOptions& options = {});

}  // namespace foramen
