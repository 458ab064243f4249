#include "pages/model_pictures.hpp"

#include <algorithm>
#include <utility>

#include "render/close_up.hpp"
#include "render/torus_scenes.hpp"
#include "render/vertebra_scenes.hpp"

namespace foramen {
namespace {

constexpr int picture_width = 1000, plate_width = 1400;  // pixels
constexpr int pictured_modes = 3;
constexpr double pictured_sd = 2;
constexpr double flat_margin = 1.5;  // the flat torus is twice as wide as the other pictures of the row
constexpr double loop_radius_mm = 0.6;
constexpr int checker_count = 320;

Scene loops_scene(const Atlas& atlas) {
  const Mesh& mesh = atlas.surface;
  Scene scene;
  scene.surfaces.emplace_back().soup = mesh.soup();
  for (std::size_t k = 0; k < 2; ++k) {
    SceneCurve curve{{}, true, loop_colours[k], loop_radius_mm};
    for (VertexId v : atlas.loops[k]) curve.points.push_back(mesh.position(v));
    scene.curves.push_back(std::move(curve));
  }
  return scene;
}

// The flat torus, and the surface in the same colours.
struct MapScenes {
  Scene flat, surface;
};
MapScenes map_scenes(const Atlas& atlas) {
  const Vec2i cells = checker_cells(atlas.map.lattice, checker_count);
  MapScenes scenes{torus_map_scene(atlas.surface, atlas.map, cells, atlas.loops), {}};
  scenes.surface.surfaces.push_back(checkered_surface(atlas.surface, atlas.map, cells));
  return scenes;
}

ReportPicture loops_picture(const Atlas& atlas) {
  return {"The reference with its two loops: the shortest system over all basepoints",
          render_png({three_views(atlas.surface.positions(), loops_scene(atlas))}, picture_width), "loops"};
}

ReportPicture map_picture(const Atlas& atlas) {
  const MapScenes scenes = map_scenes(atlas);
  return {
      "The reference's map to the flat torus, cut open along the two loops (borders of one colour are one "
      "loop), and the surface below: a cell of the torus has the same colour on both",
      render_png({{scenes.flat}, three_views(atlas.surface.positions(), scenes.surface)}, picture_width),
      "torus_map"};
}

Scene plain_scene(const ShapeModel& model, const Eigen::VectorXd& shape, SurfaceStyle style) {
  Scene scene;
  SceneSurface& surface = scene.surfaces.emplace_back();
  surface.soup = {unflattened(shape), model.triangles()};
  surface.style = style;
  return scene;
}

// All points of the mode at -2 and +2 sd and of the mean.
std::vector<Vec3> points_of_mode(const ShapeModel& model, int mode) {
  std::vector<Vec3> shown;
  for (double sd : {-pictured_sd, 0.0, pictured_sd})
    for (const Vec3& p : unflattened(model.along_mode(mode, sd))) shown.push_back(p);
  return shown;
}

ReportPicture mode_picture(const ShapeModel& model, int mode) {
  const auto mean = unflattened(model.mean());
  const auto shown = points_of_mode(model, mode);
  std::vector<std::vector<Scene>> rows;
  for (View view : {View::along_shortest, View::along_middle}) {
    auto& row = rows.emplace_back();
    for (double sd : {-pictured_sd, 0.0, pictured_sd}) {
      row.push_back(plain_scene(model, model.along_mode(mode, sd), SurfaceStyle::smooth));
      row.back().camera = view_of(mean, view, shown);
    }
  }
  return {"Mode " + std::to_string(mode + 1) + ": -2 sd, mean, +2 sd, in two views",
          render_png(rows, picture_width), "mode" + std::to_string(mode + 1)};
}

std::vector<Scene> flips_beside(const FlippedMesh& baseline, const FlippedMesh& ours, const Camera& camera,
                                SurfaceStyle style) {
  return {{{marked_surface(baseline.soup, baseline.flipped, style)}, {}, {}, camera},
          {{marked_surface(ours.soup, ours.flipped, style)}, {}, {}, camera}};
}

std::string count_of(const FlippedMesh& mesh) {
  return std::to_string(mesh.flipped.size()) + " of " + std::to_string(mesh.soup.triangles.size());
}

}  // namespace

std::vector<ReportPicture> model_pictures(const Atlas& atlas, const ShapeModel& model) {
  if (!can_render()) return {};
  std::vector<ReportPicture> pictures{loops_picture(atlas), map_picture(atlas)};
  for (int m = 0; m < std::min(pictured_modes, model.modes()); ++m)
    pictures.push_back(mode_picture(model, m));
  return pictures;
}

ReportPicture overview_picture(const Atlas& atlas, const ShapeModel& model) {
  const auto surface = atlas.surface.positions();
  const auto mean = unflattened(model.mean());
  MapScenes map = map_scenes(atlas);
  std::vector<Scene> strip{loops_scene(atlas), std::move(map.flat), std::move(map.surface),
                           plain_scene(model, model.mean(), SurfaceStyle::triangles)};
  strip[1].surfaces.resize(1);  // without the triangles' edges, which are too fine here
  strip[1].camera.height_mm *= flat_margin;
  strip[0].camera = strip[2].camera = view_of(surface, View::along_shortest, surface);
  strip[3].camera = view_of(mean, View::along_shortest, mean);
  return {
      "From left to right: the reference with its two loops; its map to the flat torus, cut open along "
      "them; the cells of the torus on the surface; the mean of the model with its " +
          std::to_string(model.landmarks()) + " landmarks and their triangles",
      render_png({strip}, plate_width), "overview"};
}

ReportPicture first_mode_beside(const PicturedModel& baseline, const PicturedModel& ours) {
  std::vector<std::vector<Scene>> rows;
  std::vector<Vec3> shown;
  for (double sd : {pictured_sd, -pictured_sd}) {
    auto& row = rows.emplace_back();
    for (const PicturedModel& pictured : {baseline, ours}) {
      const ShapeModel& model = *pictured.model;
      row.push_back(
          plain_scene(model, model.along_mode(0, pictured.first_mode_sign * sd), SurfaceStyle::facets));
      for (Vec3& p : row.back().surfaces[0].soup.points) shown.push_back(p = pictured.placement * p);
    }
  }
  auto mean = unflattened(ours.model->mean());
  for (Vec3& p : mean) p = ours.placement * p;
  for (auto& row : rows)
    for (Scene& scene : row) scene.camera = view_of(mean, View::along_shortest, shown);
  return {"The first mode at +2 sd (above) and -2 sd (below): baseline (left), this model (right)",
          render_png(rows, picture_width), "first_mode_beside"};
}

ReportPicture flips_picture(const std::string& shape, const FlippedMesh& baseline, const FlippedMesh& ours) {
  std::vector<Vec3> both = baseline.soup.points;
  both.insert(both.end(), ours.soup.points.begin(), ours.soup.points.end());
  const Camera whole = view_of(ours.soup.points, View::along_shortest, both);
  std::vector<std::vector<Scene>> rows{flips_beside(baseline, ours, whole, SurfaceStyle::facets)};
  std::string caption = "Flipped triangles (red) of " + shape + ": baseline " + count_of(baseline) +
                        " (left), this model " + count_of(ours) + " (right)";
  if (!baseline.flipped.empty()) {
    rows.push_back(
        flips_beside(baseline, ours, close_up(baseline.soup, baseline.flipped), SurfaceStyle::triangles));
    caption += "; below, the place and side where most of them are seen";
  }
  return {caption, render_png(rows, picture_width), "flips"};
}

}  // namespace foramen
