// Pictures whose colours are lengths in mm.

#include <algorithm>
#include <cmath>

#include "findings/model_report.hpp"
#include "foramen/core/error.hpp"
#include "foramen/evaluate/representation.hpp"
#include "pages/model_pictures.hpp"
#include "render/colour_scale.hpp"
#include "render/vertebra_scenes.hpp"

namespace foramen {
namespace {

constexpr int picture_width = 1000, plate_width = 1400;  // pixels
constexpr int plate_modes = 4;
constexpr double pictured_sd = 2;

double largest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

std::string told(const std::vector<double>& mm) { return "largest " + fixed(largest(mm), 2) + " mm"; }

std::string distances_png(const TriangleSoup& surface, const std::vector<double>& mm) {
  const ColourScale scale = scale_for(mm, "mm");
  Scene contents;
  contents.surfaces.push_back(coloured_surface(surface, mm, scale));
  std::vector<Scene> row = three_views(surface.points, contents);
  row.push_back(colour_bar(scale, row.front().camera.height_mm));
  return render_png({row}, picture_width);
}

// The distance by which each landmark moves at 1 standard deviation of a mode.
std::vector<double> movement(const ShapeModel& model, int mode) {
  std::vector<double> mm;
  for (const Vec3& d : unflattened(model.along_mode(mode, 1) - model.mean())) mm.push_back(d.norm());
  return mm;
}

}  // namespace

ReportPicture mean_distance_picture(const ShapeModel& model, const std::vector<ErrorMap>& maps) {
  FORAMEN_ASSERT(!maps.empty());
  std::vector<double> mm(model.landmarks(), 0.0);
  for (const ErrorMap& map : maps)
    for (std::size_t i = 0; i < mm.size(); ++i) mm[i] += map.landmark_mm[i] * map.landmark_mm[i];
  for (double& square : mm) square = std::sqrt(square / static_cast<double>(maps.size()));
  return {"Distance of the corresponding meshes to their inputs: root mean square over " +
              std::to_string(maps.size()) +
              " shapes of the largest found around each landmark, on the mean; " + told(mm),
          distances_png({unflattened(model.mean()), model.triangles()}, mm), "distances_mean"};
}

ReportPicture shape_distance_picture(const std::string& shape, const TriangleSoup& corresponding,
                                     const ErrorMap& map) {
  return {"Distance of the corresponding mesh of " + shape +
              " to its input, the largest found around each landmark; " + told(map.landmark_mm),
          distances_png(corresponding, map.landmark_mm), "distances_worst"};
}

ReportPicture modes_plate(const ShapeModel& model) {
  FORAMEN_ASSERT(model.modes() > 0);
  const int modes = std::min(plate_modes, model.modes());
  const auto mean = unflattened(model.mean());
  std::vector<double> moved;
  std::vector<Vec3> shown = mean;
  for (int m = 0; m < modes; ++m) {
    const auto mm = movement(model, m);
    moved.insert(moved.end(), mm.begin(), mm.end());
    for (double sd : {-pictured_sd, pictured_sd})
      for (const Vec3& p : unflattened(model.along_mode(m, sd))) shown.push_back(p);
  }
  const ColourScale scale = scale_for(moved, "mm");
  std::vector<std::vector<Scene>> rows;
  for (int m = 0; m < modes; ++m) {
    auto& row = rows.emplace_back();
    double height_mm = 0;
    for (View view : {View::along_shortest, View::along_middle})
      for (double sd : {-pictured_sd, pictured_sd}) {
        Scene& scene = row.emplace_back();
        scene.surfaces.emplace_back().soup = {unflattened(model.along_mode(m, sd)), model.triangles()};
        scene.camera = view_of(mean, view, shown);
        height_mm = std::max(height_mm, scene.camera.height_mm);
      }
    Scene& heat = row.emplace_back();
    heat.surfaces.push_back(coloured_surface({mean, model.triangles()}, movement(model, m), scale));
    heat.camera = view_of(mean, View::along_shortest, shown);
    for (Scene& scene : row) scene.camera.height_mm = height_mm;
    row.push_back(colour_bar(scale, height_mm));
  }
  return {"Modes 1 to " + std::to_string(modes) +
              ", a row each: -2 and +2 sd from one side, the same from another, and how far each point of "
              "the mean moves at 1 sd",
          render_png(rows, plate_width), "modes"};
}

}  // namespace foramen
