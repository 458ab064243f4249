#include "foramen/report/svg_chart.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

#include "foramen/core/error.hpp"
#include "report/html_text.hpp"

namespace foramen {
namespace {

constexpr double width = 440, left = 56, right = 16, title_height = 34, plot_height = 220, bottom = 46;
// The legend stands between title and curves, so that it hides none.
constexpr std::size_t legend_columns = 2;
constexpr double legend_line = 18;

// Okabe and Ito's colours, which the colour-blind can tell apart.
constexpr std::array<const char*, 6> colours{"#0072B2", "#D55E00", "#009E73",
                                             "#CC79A7", "#E69F00", "#56B4E9"};

std::string number(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

// Axis from low to high with round steps.
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

std::string line(double x1, double y1, double x2, double y2, const std::string& attributes) {
  return "<line x1=\"" + number(x1, 2) + "\" y1=\"" + number(y1, 2) + "\" x2=\"" + number(x2, 2) +
         "\" y2=\"" + number(y2, 2) + "\" " + attributes + "/>\n";
}

std::string label(double x, double y, const std::string& anchor, const std::string& text,
                  const std::string& more = {}) {
  return "<text x=\"" + number(x, 2) + "\" y=\"" + number(y, 2) + "\" text-anchor=\"" + anchor + "\" " +
         more + ">" + html_escaped(text) + "</text>\n";
}

std::string axes(const Chart& chart, const Frame& f) {
  std::string out;
  for (double v = f.y.low; v <= f.y.high + f.y.step / 2; v += f.y.step) {
    out += line(left, f.py(v), width - right, f.py(v), "class=\"grid\" stroke=\"#8884\"");
    out += label(left - 6, f.py(v) + 4, "end", number(v, f.y.digits));
  }
  for (double v = std::ceil(f.x.low / f.x.step) * f.x.step; v <= f.x.high + 1e-9; v += f.x.step)
    out += label(f.px(v), f.height - bottom + 16, "middle", number(v, f.x.digits));
  out += line(left, f.height - bottom, width - right, f.height - bottom, "stroke=\"currentColor\"");
  out += label((left + width - right) / 2, f.height - 10, "middle", chart.x_label);
  out += label(14, (f.top + f.height - bottom) / 2, "middle", chart.y_label,
               "transform=\"rotate(-90 14 " + number((f.top + f.height - bottom) / 2, 2) + ")\"");
  return out + label(left, 20, "start", chart.title, "font-weight=\"bold\"");
}

std::string curve(const ChartSeries& s, std::size_t index, const Frame& f) {
  const std::string colour = colours[index % colours.size()];
  std::string points, marks;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    // A small offset keeps the error bars of two curves apart.
    const double x = f.px(s.x[i]) + 2.0 * static_cast<double>(index), y = f.py(s.y[i]);
    points += number(x, 2) + "," + number(y, 2) + " ";
    marks +=
        "<circle cx=\"" + number(x, 2) + "\" cy=\"" + number(y, 2) + "\" r=\"3\" fill=\"" + colour + "\"/>\n";
    if (error_of(s, i) > 0)
      marks += line(x, f.py(s.y[i] - s.error[i]), x, f.py(s.y[i] + s.error[i]), "stroke=\"" + colour + "\"");
  }
  return "<g class=\"series-" + std::to_string(index) +
         "\"><polyline fill=\"none\" stroke-width=\"1.6\" stroke=\"" + colour + "\" points=\"" + points +
         "\"/>\n" + marks + "</g>\n";
}

std::string legend(const Chart& chart) {
  if (legend_lines(chart) == 0) return {};
  std::string out;
  const double column_width = (width - left - right) / legend_columns;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const std::size_t row = i / legend_columns;
    const double x = left + column_width * static_cast<double>(i % legend_columns);
    const double y = title_height + 6 + legend_line * static_cast<double>(row);
    out += "<g class=\"series-" + std::to_string(i) + "\">" +
           line(x, y - 4, x + 20, y - 4,
                "stroke-width=\"3\" stroke=\"" + std::string(colours[i % colours.size()]) + "\"") +
           label(x + 26, y, "start", chart.series[i].name) + "</g>\n";
  }
  return out;
}

}  // namespace

std::string svg_chart(const Chart& chart) {
  for (const ChartSeries& s : chart.series)
    FORAMEN_ASSERT(s.x.size() == s.y.size() && (s.error.empty() || s.error.size() == s.y.size()));
  const Frame frame = frame_of(chart);
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + number(width, 0) + " " +
                    number(frame.height, 0) + "\" role=\"img\" aria-label=\"" + html_escaped(chart.title) +
                    "\" font-family=\"sans-serif\" font-size=\"12\" fill=\"currentColor\">\n";
  out += axes(chart, frame);
  for (std::size_t i = 0; i < chart.series.size(); ++i) out += curve(chart.series[i], i, frame);
  return out + legend(chart) + "</svg>\n";
}

}  // namespace foramen
