#pragma once
/// \file
/// Charts as PDF, for papers.

#include <string>

#include "report/svg_chart.hpp"

namespace foramen {

/// A PDF 1.4 file with one page of the size of the chart. A unit of the drawing is one point. The page has
/// vector graphics, and text in Helvetica, which every reader has. Letters beyond Latin-1 become '?'.
/// Identical input gives identical bytes.
std::string pdf_chart(const Chart& chart);

}  // namespace foramen
