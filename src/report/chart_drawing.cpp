#include "report/chart_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "foramen/core/error.hpp"
#include "report/plain_number.hpp"

namespace foramen {
namespace {

constexpr double width = 440, left = 56, right = 16, title_height = 34, plot_height = 220, bottom = 46;
// The legend is placed between the title and the curves, so that it hides no curve.
constexpr std::size_t legend_columns = 2;
constexpr double legend_line = 18;
constexpr double curve_width = 1.6, dot_radius = 3, swatch_width = 3;

// An axis from low to high with round steps.
struct Axis {
  double low = 0, high = 1, step = 1;
  int digits = 0;
};

Axis round_axis(double low, double high, int steps) {
  if (!(high > low)) high = low + 1;
  const double raw = (high - low) / steps, magnitude = std::pow(10.0, std::floor(std::log10(raw)));
  double step = 10 * magnitude;
  for (double factor : {5.0, 2.0, 1.0})
    if (factor * magnitude >= raw * (1 - 1e-9)) step = factor * magnitude;
  Axis axis{std::floor(low / step) * step, std::ceil(high / step) * step, step, 0};
  axis.digits = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
  return axis;
}

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  void add(double value) {
    low = std::min(low, value);
    high = std::max(high, value);
  }
};

struct Frame {
  double top = title_height, height = title_height + plot_height + bottom;
  Axis x, y;
  double px(double v) const { return left + (v - x.low) / (x.high - x.low) * (width - left - right); }
  double py(double v) const {
    return height - bottom - (v - y.low) / (y.high - y.low) * (height - top - bottom);
  }
};

double error_of(const ChartSeries& s, std::size_t i) { return i < s.error.size() ? s.error[i] : 0.0; }

std::size_t legend_lines(const Chart& chart) {
  return chart.series.size() < 2 ? 0 : (chart.series.size() + legend_columns - 1) / legend_columns;
}

Frame frame_of(const Chart& chart) {
  const double legend_height = legend_line * static_cast<double>(legend_lines(chart));
  Frame frame{title_height + legend_height, title_height + legend_height + plot_height + bottom, {}, {}};
  Range x, y;
  for (const ChartSeries& s : chart.series)
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      x.add(s.x[i]);
      y.add(s.y[i] - error_of(s, i));
      y.add(s.y[i] + error_of(s, i));
    }
  if (x.low > x.high) return frame;
  if (y.low > 0 && y.low < y.high / 3) y.low = 0;
  frame.x = round_axis(x.low, x.high, 12);
  frame.y = round_axis(y.low, y.high, 6);
  frame.x.low = x.low;
  frame.x.high = std::max(x.high, x.low + 1);
  return frame;
}

DrawnPart axes(const Chart& chart, const Frame& f) {
  DrawnPart part;
  const double floor = f.height - bottom;
  for (double v = f.y.low; v <= f.y.high + f.y.step / 2; v += f.y.step) {
    part.strokes.push_back({{{left, f.py(v)}, {width - right, f.py(v)}}, 1, true});
    part.texts.push_back({{left - 6, f.py(v) + 4}, Anchor::end, plain_number(v, f.y.digits)});
  }
  for (double v = std::ceil(f.x.low / f.x.step) * f.x.step; v <= f.x.high + 1e-9; v += f.x.step)
    part.texts.push_back({{f.px(v), floor + 16}, Anchor::middle, plain_number(v, f.x.digits)});
  part.strokes.push_back({{{left, floor}, {width - right, floor}}});
  part.texts.push_back({{(left + width - right) / 2, f.height - 10}, Anchor::middle, chart.x_label});
  part.texts.push_back({{14, (f.top + floor) / 2}, Anchor::middle, chart.y_label, false, true});
  part.texts.push_back({{left, 20}, Anchor::start, chart.title, true});
  return part;
}

DrawnPart curve(const ChartSeries& s, std::size_t index, const Frame& f) {
  DrawnPart part{index};
  DrawnStroke line{{}, curve_width};
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    // A small offset keeps the error bars of two curves apart.
    const double x = f.px(s.x[i]) + 2.0 * static_cast<double>(index);
    line.points.emplace_back(x, f.py(s.y[i]));
    part.dots.push_back({line.points.back(), dot_radius});
    if (error_of(s, i) > 0)
      part.strokes.push_back({{{x, f.py(s.y[i] - s.error[i])}, {x, f.py(s.y[i] + s.error[i])}}});
  }
  if (line.points.size() > 1) part.strokes.push_back(std::move(line));
  return part;
}

DrawnPart legend_entry(const ChartSeries& s, std::size_t index) {
  const double column_width = (width - left - right) / legend_columns;
  const double x = left + column_width * static_cast<double>(index % legend_columns);
  const std::size_t row = index / legend_columns;
  const double y = title_height + 6 + legend_line * static_cast<double>(row);
  return {index, {{{{x, y - 4}, {x + 20, y - 4}}, swatch_width}}, {}, {{{x + 26, y}, Anchor::start, s.name}}};
}

}  // namespace

Drawing chart_drawing(const Chart& chart) {
  for (const ChartSeries& s : chart.series)
    FORAMEN_ASSERT(s.x.size() == s.y.size() && (s.error.empty() || s.error.size() == s.y.size()));
  const Frame frame = frame_of(chart);
  Drawing drawing{width, frame.height, chart.title, {axes(chart, frame)}};
  for (std::size_t i = 0; i < chart.series.size(); ++i)
    drawing.parts.push_back(curve(chart.series[i], i, frame));
  if (legend_lines(chart) > 0)
    for (std::size_t i = 0; i < chart.series.size(); ++i)
      drawing.parts.push_back(legend_entry(chart.series[i], i));
  return drawing;
}

}  // namespace foramen
