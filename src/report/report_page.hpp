#pragma once
/// \file
/// The report of a build or a comparison: one static, self-contained HTML page.

#include <string>
#include <vector>

#include "report/svg_chart.hpp"

namespace foramen {

struct ReportTable {
  std::string title, note;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

struct ReportPicture {
  std::string caption;
  std::string png;             ///< the file's bytes
  std::string file_stem = {};  ///< the name of its file without extension, if it is written to a file
};

/// The parts of a section appear in this order.
struct ReportSection {
  std::string title;
  std::vector<std::string> paragraphs = {};
  std::vector<std::string> findings = {};  ///< a list of lines
  std::vector<ReportPicture> pictures = {};
  std::vector<Chart> charts = {};
  std::vector<ReportTable> tables = {};
};

struct ReportPage {
  std::string title, subtitle;
  std::vector<ReportSection> sections;
};

/// The page as HTML. All text is escaped, and the page loads nothing else. It can be read on a phone and on a
/// wide screen, in a light and in a dark scheme, and it can be printed.
std::string report_html(const ReportPage& page);

}  // namespace foramen
