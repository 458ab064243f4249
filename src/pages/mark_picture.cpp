#include <algorithm>

#include "correspond/template_surface.hpp"
#include "findings/model_report.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "pages/model_pictures.hpp"
#include "render/vertebra_scenes.hpp"

namespace foramen {
namespace {

constexpr int picture_width = 1400;  // pixels
constexpr double curve_radius_mm = 0.2, dot_radius_mm = 0.5, dot_height_mm = 0.3;
constexpr int key_columns = 5;
// Parts of the width of a column of the key.
constexpr double key_line = 0.14, key_letter = 0.075, key_dash = 0.12;

// A point is a disc on the surface, a curve a thin tube.
SceneCurve drawn(const Mesh& mean, const VertexMap<Vec3>& normals, const PlacedMark& mark,
                 const Colour& colour) {
  SceneCurve curve{{}, mark.kind == MarkKind::closed_curve, colour, curve_radius_mm};
  for (const SurfacePoint& place : mark.places) curve.points.push_back(position(mean, place));
  if (mark.kind != MarkKind::point) return curve;
  const Vec3 normal = interpolated(mean, normals, mark.places[0]);
  const Vec3 at = curve.points[0];
  curve.points = {at - dot_height_mm * normal, at + dot_height_mm * normal};
  curve.radius = dot_radius_mm;
  return curve;
}

// The name and the scatter of every mark beside a dash of its colour, in columns over this width.
Scene key(const std::vector<PageMark>& marks, double width_mm) {
  Scene scene;
  const double column = width_mm / key_columns;
  const int lines = (static_cast<int>(marks.size()) + key_columns - 1) / key_columns;
  for (int i = 0; i < std::ssize(marks); ++i) {
    const int line = i / key_columns;
    const Vec3 start(column * (i % key_columns + key_dash / 2), 0, -key_line * column * (line + 0.5));
    const Vec3 end = start + Vec3(key_dash * column, 0, 0);
    scene.curves.push_back({{start, end}, false, marks[i].colour, key_letter * column / 4});
    scene.texts.push_back({marks[i].scatter.mark + "  " + fixed(marks[i].scatter.rms, 2) + " mm",
                           end + Vec3(key_dash / 2 * column, 0, 0), key_letter * column});
  }
  const double height_mm = key_line * column * lines;
  scene.camera = {Vec3(width_mm / 2, 0, -height_mm / 2), Vec3::UnitY(), Vec3::UnitZ(), width_mm, height_mm};
  return scene;
}

}  // namespace

ReportPicture marks_picture(const ShapeModel& model, const std::vector<PageMark>& marks) {
  FORAMEN_ASSERT(!marks.empty());
  const Mesh mean = build_mesh({unflattened(model.mean()), model.triangles()});
  const VertexMap<Vec3> normals = vertex_normals(mean);
  Scene contents;
  contents.surfaces.emplace_back().soup = mean.soup();
  for (const PageMark& mark : marks)
    for (const PlacedMark& placed : mark.scatter.placed)
      contents.curves.push_back(drawn(mean, normals, placed, mark.colour));
  const std::vector<Scene> views = three_views(mean.positions(), contents);
  double width_mm = 0;
  for (const Scene& view : views) width_mm += view.camera.width_mm;
  return {
      "The marks of all shapes on the mean, each carried there by the correspondence; numbers are their "
      "scatter, the root mean square distance to the mark's centre or mean curve",
      render_png({views, {key(marks, width_mm)}}, picture_width), "marks"};
}

}  // namespace foramen
