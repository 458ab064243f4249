#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "report/svg_chart.hpp"

namespace foramen {

/// The colours of the series, as 0xRRGGBB: the palette of Okabe and Ito, which colour-blind people can
/// distinguish. After the last colour, the first one is used again.
inline constexpr std::array<std::uint32_t, 6> series_colours{0x0072B2, 0xD55E00, 0x009E73,
                                                             0xCC79A7, 0xE69F00, 0x56B4E9};

/// A polyline of at least two points.
struct DrawnStroke {
  std::vector<Vec2> points;
  double width = 1;
  bool faint = false;  ///< a line of the grid
};

struct DrawnDot {
  Vec2 centre;
  double radius;
};

enum class Anchor { start, middle, end };

/// Text of size 12, which is always black.
struct DrawnText {
  Vec2 at;  ///< a point on the base line
  Anchor anchor;
  std::string text;  ///< UTF-8
  bool bold = false;
  bool upward = false;  ///< rotated, to be read from the right
};

/// Strokes and dots of one colour, which is that of a series or black.
struct DrawnPart {
  std::optional<std::size_t> series = std::nullopt;
  std::vector<DrawnStroke> strokes = {};
  std::vector<DrawnDot> dots = {};
  std::vector<DrawnText> texts = {};
};

/// The elements of a chart, independent of the kind of file. Coordinates are measured from the top left
/// corner, with y downward.
struct Drawing {
  double width = 0, height = 0;
  std::string title;
  std::vector<DrawnPart> parts;
};

/// Lays out the chart as svg_chart() describes.
Drawing chart_drawing(const Chart& chart);

}  // namespace foramen
