#pragma once
/// \file
/// Curves with error bars as SVG.

#include <string>
#include <vector>

namespace foramen {

struct ChartSeries {
  std::string name;
  std::vector<double> x, y;
  std::vector<double> error;  ///< half-length of the error bars (standard errors); empty: none
};

struct Chart {
  std::string title;
  std::string x_label, y_label;  ///< with unit
  std::vector<ChartSeries> series;
  std::string file_stem = {};  ///< the name of its file without extension, if it is written to a file
};

/// A self-contained <svg> element. The colours are set by the CSS classes series-0, series-1 and so on, with
/// default values, so that a page's dark scheme can change them. The y axis starts at zero when the smallest
/// value is below a third of the largest. Identical input gives identical text.
std::string svg_chart(const Chart& chart);

/// The chart as a file of its own: black on white, with a fixed size.
std::string svg_chart_file(const Chart& chart);

}  // namespace foramen
