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

/// Okabe and Ito's colours, which the colour-blind can tell apart; those of the series, again from the start
/// after the last. 0xRRGGBB.
inline constexpr std::array<std::uint32_t, 6> series_colours{0x0072B2, 0xD55E00, 0x009E73,
                                                             0xCC79A7, 0xE69F00, 0x56B4E9};

/// At least two points.
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

/// Text of size 12, black whatever the part's colour.
struct DrawnText {
  Vec2 at;  ///< on the base line
  Anchor anchor;
  std::string text;  ///< UTF-8
  bool bold = false;
  bool upward = false;  ///< turned to be read from the right
};

/// Strokes and dots of one colour: a series', or black.
struct DrawnPart {
  std::optional<std::size_t> series = std::nullopt;
  std::vector<DrawnStroke> strokes = {};
  std::vector<DrawnDot> dots = {};
  std::vector<DrawnText> texts = {};
};

/// What a chart consists of, whatever kind of file it goes to. Points from the top left corner, y downward.
struct Drawing {
  double width = 0, height = 0;
  std::string title;
  std::vector<DrawnPart> parts;
};

/// See svg_chart().
Drawing chart_drawing(const Chart& chart);

}  // namespace foramen
