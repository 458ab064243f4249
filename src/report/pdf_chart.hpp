#pragma once
/// \file
/// The same curves as PDF, for papers.

#include <string>

#include "report/svg_chart.hpp"

namespace foramen {

/// A PDF file (1.4) of one page as large as the chart, a unit of the drawing being a point: vector graphics,
/// text in Helvetica, which every reader has. Letters beyond Latin-1 become '?'. Identical input gives
/// identical bytes.
std::string pdf_chart(const Chart& chart);

}  // namespace foramen
