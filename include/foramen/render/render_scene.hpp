#pragma once
/// \file
/// Off-screen pictures of surfaces and curves, by VTK. Needs a display: run under xvfb-run where there is
/// none.

#include <array>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

using Colour = std::array<unsigned char, 3>;

struct SceneSurface {
  TriangleSoup soup;
  std::vector<Colour> vertex_colours;  ///< one per point, or empty
  std::vector<Colour>
      face_colours;  ///< one per triangle, or empty; drawn flat. Not together with vertex_colours.
  Colour colour{226, 214, 196};  ///< where neither is given
  bool edges = false;            ///< draw the triangles' edges
  bool lit = true;               ///< false: plain colours, for flat maps
};

struct SceneCurve {
  std::vector<Vec3> points;
  bool closed = false;
  Colour colour{200, 30, 30};
  double radius = 0.6;  ///< mm
};

/// One view: the camera looks along `direction` at everything, with `up` upward, in parallel projection.
struct Scene {
  std::vector<SceneSurface> surfaces;
  std::vector<SceneCurve> curves;
  Vec3 direction = Vec3(0, -1, 0);
  Vec3 up = Vec3(0, 0, 1);
  double height_mm = 0;  ///< of the picture; 0: everything fits
};

struct PictureSize {
  int width = 640, height = 480;  ///< pixels of each scene
};

/// Whether pictures can be made here: this build has VTK and there is a display.
bool can_render();

/// PNG bytes of the scenes side by side, in `columns` columns. Throws Error if can_render() is false.
std::string render_png(const std::vector<Scene>& scenes, int columns, const PictureSize& size = {});

}  // namespace foramen
