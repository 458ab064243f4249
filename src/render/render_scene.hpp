#pragma once
/// \file
/// Off-screen pictures of surfaces and curves, by VTK. VTK needs a display; xvfb-run provides one.

#include <array>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

using Colour = std::array<unsigned char, 3>;

enum class SurfaceStyle {
  smooth,     ///< lit, shaded by normals at the points
  facets,     ///< lit, each triangle flat
  triangles,  ///< lit, each triangle flat, with its edges
  flat_map,   ///< plain colours without light
  wires       ///< the triangles' edges alone
};

struct SceneSurface {
  TriangleSoup soup;
  SurfaceStyle style = SurfaceStyle::smooth;
  std::vector<Vec3> vertex_normals;    ///< one per point; if empty, computed from the triangles. For smooth.
  std::vector<Colour> vertex_colours;  ///< one per point, or empty
  std::vector<Colour> face_colours;  ///< one per triangle, or empty. Must be empty if vertex_colours is not.
  Colour colour{226, 214, 196};      ///< colour of a surface without vertex_colours and face_colours
};

struct SceneCurve {
  std::vector<Vec3> points;
  bool closed = false;
  Colour colour{200, 30, 30};
  double radius = 0.6;  ///< mm
};

/// One line of text in the plane of the picture.
struct SceneText {
  std::string text;
  Vec3 at = Vec3::Zero();  ///< the middle of its left edge
  double height_mm = 1;    ///< font size
};

/// Parallel projection. `direction` is where the camera looks, `up` is upward in the picture.
struct Camera {
  Vec3 centre = Vec3::Zero();  ///< the middle of the picture
  Vec3 direction = Vec3::UnitY(), up = Vec3::UnitZ();
  double width_mm = 1, height_mm = 1;  ///< size of the part of space that the picture shows
};

struct Scene {
  std::vector<SceneSurface> surfaces;
  std::vector<SceneCurve> curves;
  std::vector<SceneText> texts = {};
  Camera camera;
};

/// The bytes of a PNG file with rows of scenes, from top to bottom. A row fills the width of the picture. The
/// scenes of a row have the same height, and each has the aspect ratio of its camera. Throws Error if
/// can_render() is false.
std::string render_png(const std::vector<std::vector<Scene>>& rows, int width_pixels);

/// Whether pictures can be made, which needs a build with VTK and a display.
bool can_render();

}  // namespace foramen
