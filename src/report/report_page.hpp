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
  std::string file_stem = {};  ///< what its file is called, where it is written to one
};

/// Its parts appear in this order.
struct ReportSection {
  std::string title;
  std::vector<std::string> paragraphs = {};
  std::vector<std::string> findings = {};  ///< a list, a line each
  std::vector<ReportPicture> pictures = {};
  std::vector<Chart> charts = {};
  std::vector<ReportTable> tables = {};
};

struct ReportPage {
  std::string title, subtitle;
  std::vector<ReportSection> sections;
};

/// All text is escaped; nothing is loaded from elsewhere. Readable on a phone and on a wide screen, light and
/// dark, printable.
std::string report_html(const ReportPage& page);

}  // namespace foramen
