#pragma once
/// \file
/// Colours for numbers on a surface, and the colour bar that explains them.

#include <span>
#include <string>

#include "render/render_scene.hpp"

namespace foramen {

/// Colours for values from 0 to `high`: from the colour of bone through amber and red to plum, with
/// decreasing lightness. The interactive page uses the same colours.
struct ColourScale {
  double high = 1;        ///< Larger values have the last colour. > 0.
  std::string unit = {};  ///< text beside the last tick of the bar
};

/// A round number that is at least the value and not much larger; 1 for the value 0.
double rounded_up(double value);

/// The scale that ends at a round number, which at most the share `beyond` of the values exceeds. Outliers
/// therefore do not determine it.
/// \pre there are values; 0 <= beyond < 1.
ColourScale scale_for(std::span<const double> values, const std::string& unit, double beyond = 0.005);

Colour colour_of(const ColourScale& scale, double value);

/// The surface with each point in the colour of its value. \pre as many values as points
SceneSurface coloured_surface(const TriangleSoup& surface, std::span<const double> values,
                              const ColourScale& scale);

/// A vertical colour bar with numbers at its ticks, for a picture of this height.
Scene colour_bar(const ColourScale& scale, double height_mm);

}  // namespace foramen
