#pragma once
/// \file
/// Numbers on a surface as colours, and the bar that says which number a colour is.

#include <span>
#include <string>

#include "render/render_scene.hpp"

namespace foramen {

/// From 0 to `high`: bone through amber and red to plum, lightness falls all the way. The colours of the
/// report's page.
struct ColourScale {
  double high = 1;        ///< what is above has the last colour. > 0.
  std::string unit = {};  ///< written at the last tick of the bar
};

/// A round number that is not below the value, and not much above; 1 for 0.
double rounded_up(double value);

/// The scale to the round number above all but `beyond` of the values: single ones do not decide.
/// \pre there are values; 0 <= beyond < 1.
ColourScale scale_for(std::span<const double> values, const std::string& unit, double beyond = 0.005);

Colour colour_of(const ColourScale& scale, double value);

/// The surface in the colours of a value at each of its points. \pre as many values as points
SceneSurface coloured_surface(const TriangleSoup& surface, std::span<const double> values,
                              const ColourScale& scale);

/// An upright bar with numbers at its ticks, as tall as a picture of `height_mm` allows.
Scene colour_bar(const ColourScale& scale, double height_mm);

}  // namespace foramen
