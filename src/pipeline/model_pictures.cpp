#include "foramen/pipeline/model_pictures.hpp"

#include <algorithm>
#include <utility>

#include "foramen/render/close_up.hpp"
#include "foramen/render/torus_scenes.hpp"
#include "foramen/render/vertebra_scenes.hpp"

namespace foramen {
namespace {

constexpr int picture_width = 1000;  // pixels
constexpr int pictured_modes = 3;
constexpr double loop_radius_mm = 0.6;
constexpr int checker_count = 320;

// Scenes beside each other at one scale.
std::vector<Scene> at_one_scale(std::vector<Scene> scenes) {
  double height_mm = 0;
  for (const Scene& scene : scenes) height_mm = std::max(height_mm, scene.camera.height_mm);
  for (Scene& scene : scenes) scene.camera.height_mm = height_mm;
  return scenes;
}

// The surface from three sides, with whatever `dress` adds.
template <class Dress>
std::vector<Scene> three_views(const Mesh& mesh, const Dress& dress) {
  std::vector<Scene> scenes;
  for (View view : {View::along_shortest, View::along_middle, View::along_longest}) {
    Scene& scene = scenes.emplace_back();
    scene.camera = view_of(mesh.positions(), view, mesh.positions());
    dress(scene);
  }
  return at_one_scale(std::move(scenes));
}

ReportPicture loops_picture(const Atlas& atlas) {
  const Mesh& mesh = atlas.surface;
  const auto with_loops = [&](Scene& scene) {
    scene.surfaces.emplace_back().soup = mesh.soup();
    for (std::size_t k = 0; k < 2; ++k) {
      SceneCurve curve{{}, true, loop_colours[k], loop_radius_mm};
      for (VertexId v : atlas.loops[k]) curve.points.push_back(mesh.position(v));
      scene.curves.push_back(std::move(curve));
    }
  };
  return {"The reference with its two loops: the shortest system over all basepoints",
          render_png({three_views(mesh, with_loops)}, picture_width)};
}

ReportPicture map_picture(const Atlas& atlas) {
  const Mesh& mesh = atlas.surface;
  const Vec2i cells = checker_cells(atlas.map.lattice, checker_count);
  const auto checkered = [&](Scene& scene) {
    scene.surfaces.push_back(checkered_surface(mesh, atlas.map, cells));
  };
  return {
      "The reference's map to the flat torus, cut open along the two loops (borders of one colour are one "
      "loop), and the surface below: a cell of the torus has the same colour on both",
      render_png({{torus_map_scene(mesh, atlas.map, cells, atlas.loops)}, three_views(mesh, checkered)},
                 picture_width)};
}

ReportPicture mode_picture(const ShapeModel& model, int mode) {
  const auto mean = unflattened(model.mean());
  std::vector<std::vector<Vec3>> shapes;
  std::vector<Vec3> shown;
  for (double sd : {-2.0, 0.0, 2.0}) {
    shapes.push_back(unflattened(model.along_mode(mode, sd)));
    shown.insert(shown.end(), shapes.back().begin(), shapes.back().end());
  }
  std::vector<std::vector<Scene>> rows;
  for (View view : {View::along_shortest, View::along_middle}) {
    auto& row = rows.emplace_back();
    for (const auto& points : shapes) {
      Scene& scene = row.emplace_back();
      scene.surfaces.emplace_back().soup = {points, model.triangles()};
      scene.camera = view_of(mean, view, shown);
    }
  }
  return {"Mode " + std::to_string(mode + 1) + ": -2 sd, mean, +2 sd, in two views",
          render_png(rows, picture_width)};
}

std::vector<Scene> flips_beside(const FlippedMesh& baseline, const FlippedMesh& ours, const Camera& camera,
                                SurfaceStyle style) {
  return {{{marked_surface(baseline.soup, baseline.flipped, style)}, {}, camera},
          {{marked_surface(ours.soup, ours.flipped, style)}, {}, camera}};
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
  return {caption, render_png(rows, picture_width)};
}

}  // namespace foramen
