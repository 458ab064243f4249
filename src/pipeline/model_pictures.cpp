#include "foramen/pipeline/model_pictures.hpp"

#include <algorithm>
#include <utility>

#include "foramen/render/vertebra_scenes.hpp"

namespace foramen {
namespace {

constexpr Colour first_loop{200, 30, 30}, second_loop{20, 90, 200};
constexpr int pictured_modes = 3;

SceneSurface surface_of(TriangleSoup soup, std::vector<Colour> vertex_colours = {}) {
  SceneSurface surface;
  surface.soup = std::move(soup);
  surface.vertex_colours = std::move(vertex_colours);
  return surface;
}

Scene loops_scene(const Atlas& atlas, View view) {
  Scene scene;
  const Mesh& mesh = atlas.surface;
  scene.surfaces.push_back(surface_of(mesh.soup()));
  for (std::size_t k = 0; k < 2; ++k) {
    SceneCurve curve{{}, true, k == 0 ? first_loop : second_loop, 0.7};
    for (VertexId v : atlas.loops[k]) curve.points.push_back(mesh.position(v));
    scene.curves.push_back(std::move(curve));
  }
  look(scene, mesh.positions(), view);
  return scene;
}

ReportPicture loops_picture(const Atlas& atlas) {
  return {"The reference with its two loops: the shortest system over all basepoints",
          render_png({loops_scene(atlas, View::along_shortest), loops_scene(atlas, View::along_middle)}, 2)};
}

ReportPicture map_picture(const Atlas& atlas) {
  const TorusMap& map = atlas.map;
  const TriangleSoup soup = atlas.surface.soup();
  Scene checked;
  checked.surfaces.push_back(surface_of(soup, checkerboard(map.turns.values(), 24)));
  look(checked, soup.points, View::along_shortest);
  return {
      "Its map to the flat torus (left; triangles that cross the cut are drawn where they begin), and a "
      "checkerboard of the torus on the surface",
      render_png({torus_map_scene(soup, map.turns.values(), map.jumps.values(), map.lattice), checked}, 2)};
}

Scene shape_scene(const ShapeModel& model, const Eigen::VectorXd& shape, std::span<const Vec3> mean,
                  View view) {
  Scene scene;
  scene.surfaces.push_back(surface_of({unflattened(shape), model.triangles()}));
  look(scene, mean, view);
  return scene;
}

ReportPicture mode_picture(const ShapeModel& model, int mode) {
  const auto mean = unflattened(model.mean());
  std::vector<Scene> scenes;
  for (View view : {View::along_shortest, View::along_middle})
    for (double sd : {-2.0, 0.0, 2.0})
      scenes.push_back(shape_scene(model, model.along_mode(mode, sd), mean, view));
  return {"Mode " + std::to_string(mode + 1) + ": -2 sd, mean, +2 sd, in two views",
          render_png(scenes, 3, {.width = 420, .height = 340})};
}

}  // namespace

std::vector<ReportPicture> model_pictures(const Atlas& atlas, const ShapeModel& model) {
  if (!can_render()) return {};
  std::vector<ReportPicture> pictures{loops_picture(atlas), map_picture(atlas)};
  for (int m = 0; m < std::min(pictured_modes, model.modes()); ++m)
    pictures.push_back(mode_picture(model, m));
  return pictures;
}

ReportPicture flips_picture(const std::vector<FlippedMesh>& meshes) {
  std::vector<Scene> scenes;
  std::string caption = "Flipped triangles (red):";
  for (const FlippedMesh& mesh : meshes)
    for (View view : {View::along_shortest, View::along_middle}) {
      Scene scene;
      scene.surfaces.push_back(marked_surface(mesh.soup, mesh.flipped));
      look(scene, meshes.front().soup.points, view);
      scenes.push_back(std::move(scene));
    }
  for (const FlippedMesh& mesh : meshes)
    caption += " " + mesh.name + " " + std::to_string(mesh.flipped.size());
  return {caption, render_png(scenes, 2)};
}

}  // namespace foramen
