#include "synth/vertebra_features.hpp"

#include <cmath>
#include <numbers>

namespace foramen::synth {

Process spinous_process() { return {{0, 40, -7}, {0, 64, -12}, 9}; }

std::array<Process, 3> left_processes() {
  return {Process{{17, 29.5, 3.5}, {43, 35.7, 5.2}, 6}, Process{{17, 31, 3}, {18.5, 33.5, 19}, 6},
          Process{{12, 35, -10}, {11, 37, -29}, 6}};
}

std::array<Facet, 2> left_facets() {
  const auto facet = [](const Vec3& centre, const Vec3& normal, const Vec3& towards_tip) {
    const Vec3 n = normal.normalized();
    return Facet{centre, n, (towards_tip - towards_tip.dot(n) * n).normalized()};
  };
  return {facet({14.7, 35.4, 10.7}, {-1, 0.32, 0.04}, Vec3::UnitZ()),
          facet({13.6, 34.0, -20.5}, {0.6, -0.8, 0.16}, -Vec3::UnitZ())};
}

std::vector<RimPoint> endplate_rim(int side, int points) {
  // The outline is a superellipse, and the edge of the body is rounded, so that the rim lies a little within
  // the outermost width, depth and height.
  constexpr double half_width = 22, half_depth = 15.5, height = 12.3, flattening = 0.8;
  std::vector<RimPoint> rim;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * k / points, c = std::cos(angle), s = std::sin(angle);
    const Vec3 position(std::copysign(half_width * std::pow(std::abs(c), flattening), c),
                        std::copysign(half_depth * std::pow(std::abs(s), flattening), s), side * height);
    const Vec3 outward = Vec3(c / half_width, s / half_depth, 0).normalized();
    rim.push_back({position, outward, side * Vec3::UnitZ(), angle});
  }
  return rim;
}

}  // namespace foramen::synth
