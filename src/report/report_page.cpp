#include "report/report_page.hpp"

#include "report/html_text.hpp"

namespace foramen {
namespace {

constexpr const char* style = R"(
:root { color-scheme: light dark; --line: #8886; --faint: #8881; }
body { font: 16px/1.5 system-ui, sans-serif; margin: 0 auto; padding: 1rem; max-width: 1200px; overflow-wrap: anywhere; }
h1 { margin-bottom: 0; } .subtitle { margin-top: 0; opacity: .75; }
h2 { border-bottom: 1px solid var(--line); padding-bottom: .2rem; margin-top: 2.2rem; }
ul { padding-left: 1.2rem; } figure { margin: 0; } figcaption, .note { font-size: .88rem; opacity: .8; }
.pictures { columns: 2 420px; column-gap: 2rem; } .pictures figure { break-inside: avoid; margin-bottom: 1.5rem; }
figure img { display: block; width: 100%; height: auto; background: #fff; border-radius: 4px; margin-bottom: .3rem; }
.charts { display: grid; grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr)); gap: 1rem 2rem; }
.tables { display: flex; flex-wrap: wrap; gap: 0 3rem; } .table { min-width: 17rem; max-width: 100%; }
.table h3, .table .note { width: 0; min-width: 100%; } .table h3 { font-size: 1rem; } .scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .92rem; margin: .5rem 0; font-variant-numeric: tabular-nums; }
th, td { padding: .25rem .6rem; border-bottom: 1px solid var(--line); text-align: right; white-space: nowrap; }
th:first-child, td:first-child { text-align: left; } thead th { background: var(--faint); }
td.long { text-align: left; white-space: normal; min-width: 13rem; }
@media (prefers-color-scheme: dark) {
  .series-0 polyline { stroke: #3a9bdc; } .series-0 circle { fill: #3a9bdc; }
}
@media print {
  :root { color-scheme: light; } body { max-width: none; padding: 0; font-size: 11pt; }
  h2, h3 { break-after: avoid; } figure, tr { break-inside: avoid; } .scroll { overflow: visible; }
  .charts { grid-template-columns: 1fr 1fr; } .pictures { columns: 2; }
}
)";

// Longer cells are treated as prose, not as figures.
constexpr std::size_t prose_length = 40;

std::string table_html(const ReportTable& table) {
  std::string out = "<div class=\"table\">\n<h3>" + html_escaped(table.title) + "</h3>\n";
  if (!table.note.empty()) out += "<p class=\"note\">" + html_escaped(table.note) + "</p>\n";
  out += "<div class=\"scroll\"><table><thead><tr>";
  for (const auto& cell : table.header) out += "<th scope=\"col\">" + html_escaped(cell) + "</th>";
  out += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (const auto& cell : row)
      out += (cell.size() > prose_length ? "<td class=\"long\">" : "<td>") + html_escaped(cell) + "</td>";
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n</div>\n";
}

std::string picture_html(const ReportPicture& picture) {
  const std::string caption = html_escaped(picture.caption);
  return "<figure><img alt=\"" + caption + "\" src=\"data:image/png;base64," + base64(picture.png) +
         "\"><figcaption>" + caption + "</figcaption></figure>\n";
}

std::string section_html(const ReportSection& section) {
  std::string out = "<section>\n<h2>" + html_escaped(section.title) + "</h2>\n";
  for (const auto& text : section.paragraphs) out += "<p>" + html_escaped(text) + "</p>\n";
  if (!section.findings.empty()) {
    out += "<ul>\n";
    for (const auto& text : section.findings) out += "<li>" + html_escaped(text) + "</li>\n";
    out += "</ul>\n";
  }
  if (!section.pictures.empty()) {
    out += "<div class=\"pictures\">\n";
    for (const auto& picture : section.pictures) out += picture_html(picture);
    out += "</div>\n";
  }
  if (!section.charts.empty()) {
    out += "<div class=\"charts\">\n";
    for (const auto& chart : section.charts) out += "<figure>" + svg_chart(chart) + "</figure>\n";
    out += "</div>\n";
  }
  if (!section.tables.empty()) {
    out += "<div class=\"tables\">\n";
    for (const auto& table : section.tables) out += table_html(table);
    out += "</div>\n";
  }
  return out + "</section>\n";
}

}  // namespace

std::string report_html(const ReportPage& page) {
  const std::string title = html_escaped(page.title);
  std::string out =
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
      title + "</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" + title +
      "</h1>\n<p class=\"subtitle\">" + html_escaped(page.subtitle) + "</p>\n";
  for (const auto& section : page.sections) out += section_html(section);
  return out + "</body>\n</html>\n";
}

}  // namespace foramen
