#include "render/colour_scale.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// The colours at evenly spaced values.
constexpr std::array<Colour, 5> ramp{Colour{0xe2, 0xd6, 0xc4}, Colour{0xec, 0xb5, 0x5f},
                                     Colour{0xdd, 0x6f, 0x3a}, Colour{0xb0, 0x27, 0x3f},
                                     Colour{0x4d, 0x14, 0x50}};

// Lengths as shares of the picture's height.
constexpr double bar_height = 0.7, bar_width = 0.05, picture_width = 0.32, letter_height = 0.055;
constexpr double gap = 0.02;

std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.4g", value);
  return text;
}

}  // namespace

double rounded_up(double value) {
  if (!(value > 0)) return 1;
  const double magnitude = std::pow(10.0, std::floor(std::log10(value)));
  for (double factor : {1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (factor * magnitude >= value * (1 - 1e-9)) return factor * magnitude;
  return 10 * magnitude;
}

ColourScale scale_for(std::span<const double> values, const std::string& unit, double beyond) {
  FORAMEN_ASSERT(!values.empty() && 0 <= beyond && beyond < 1);
  std::vector<double> sorted(values.begin(), values.end());
  std::sort(sorted.begin(), sorted.end());
  const auto above = static_cast<std::size_t>(beyond * static_cast<double>(sorted.size()));
  return {rounded_up(sorted[sorted.size() - 1 - above]), unit};
}

Colour colour_of(const ColourScale& scale, double value) {
  const double place = std::clamp(value / scale.high, 0.0, 1.0) * (ramp.size() - 1);
  const std::size_t step = std::min(static_cast<std::size_t>(place), ramp.size() - 2);
  Colour colour;
  for (std::size_t k = 0; k < colour.size(); ++k)
    colour[k] = static_cast<unsigned char>(std::lround(
        std::lerp(double(ramp[step][k]), double(ramp[step + 1][k]), place - static_cast<double>(step))));
  return colour;
}

SceneSurface coloured_surface(const TriangleSoup& surface, std::span<const double> values,
                              const ColourScale& scale) {
  FORAMEN_ASSERT(values.size() == surface.points.size());
  SceneSurface scene;
  scene.soup = surface;
  for (double value : values) scene.vertex_colours.push_back(colour_of(scale, value));
  return scene;
}

Scene colour_bar(const ColourScale& scale, double height_mm) {
  Scene scene;
  const double width = bar_width * height_mm, height = bar_height * height_mm;
  SceneSurface& bar = scene.surfaces.emplace_back();
  bar.style = SurfaceStyle::flat_map;
  for (std::size_t i = 0; i < ramp.size(); ++i) {
    const double z = height * static_cast<double>(i) / (ramp.size() - 1);
    const int at = static_cast<int>(bar.soup.points.size());
    bar.soup.points.insert(bar.soup.points.end(), {Vec3(0, 0, z), Vec3(width, 0, z)});
    bar.vertex_colours.insert(bar.vertex_colours.end(), 2, ramp[i]);
    if (i == 0) continue;
    bar.soup.triangles.push_back({at - 2, at - 1, at + 1});
    bar.soup.triangles.push_back({at - 2, at + 1, at});
  }
  constexpr int ticks = 2;
  for (int i = 0; i <= ticks; ++i) {
    const double share = double(i) / ticks;
    const std::string unit = i == ticks && !scale.unit.empty() ? " " + scale.unit : "";
    scene.texts.push_back({short_number(share * scale.high) + unit,
                           Vec3(width + gap * height_mm, 0, share * height), letter_height * height_mm});
  }
  scene.camera = {Vec3((picture_width / 2 - gap) * height_mm, 0, height / 2), Vec3::UnitY(), Vec3::UnitZ(),
                  picture_width * height_mm, height_mm};
  return scene;
}

}  // namespace foramen
