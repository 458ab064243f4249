#include "synth/rough_deformation.hpp"

#include <cmath>

#include "foramen/core/geometry.hpp"
#include "synth/rough_motions.hpp"

namespace foramen::synth {
namespace {

struct Scale {
  double correlation_mm, amplitude_mm;
  int steps;  // of the Runge-Kutta method
};
constexpr Scale scales[] = {{4, 0.1, 2}, {8, 0.18, 2}, {16, 0.3, 2}};
constexpr double left_right_correlation = 0.6;
constexpr int motion_steps = 16;
constexpr int features = 96;  // of a field

}  // namespace

RoughDeformation::RoughDeformation(Rng& rng) : motions_(rough_motions(rng)) {
  for (const Scale& scale : scales) {
    const std::vector<VelocityField> field{symmetric_velocity_field(
        left_right_correlation, {.correlation_mm = scale.correlation_mm, .features = features}, rng)};
    flows_.push_back({weighted_sum(field, std::vector<double>{scale.amplitude_mm}), scale.steps});
  }
}

std::vector<Vec3> RoughDeformation::carried(std::span<const Vec3> points) const {
  std::vector<Vec3> moved = carried_by_flow(points, motions_, motion_steps);
  for (const Flow& flow : flows_) moved = carried_by_flow(moved, flow.field, flow.steps);
  return moved;
}

int rough_vertex_count(int vertices, Rng& rng) {
  constexpr double fewest = 0.6, most = 1.6;
  return static_cast<int>(std::lround(vertices * std::exp(rng.uniform(std::log(fewest), std::log(most)))));
}

void add_segmentation_noise(TriangleSoup& surface, Rng& rng) {
  constexpr double correlation_mm = 2, amplitude_mm = 0.12;
  const auto field = random_velocity_fields(1, {.correlation_mm = correlation_mm}, rng);
  std::vector<Vec3> normals(surface.points.size(), Vec3::Zero());
  for (const auto& t : surface.triangles) {
    const Vec3 n = area_vector({surface.points[t[0]], surface.points[t[1]], surface.points[t[2]]});
    for (const int v : t) normals[v] += n;
  }
  for (std::size_t v = 0; v < normals.size(); ++v)
    surface.points[v] += amplitude_mm * field[0](surface.points[v]).x() * normals[v].normalized();
}

}  // namespace foramen::synth
