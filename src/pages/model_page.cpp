#include "pages/model_page.hpp"

#include <cstdio>

#include <nlohmann/json.hpp>

#include "findings/model_findings.hpp"
#include "findings/model_report.hpp"
#include "foramen/core/error.hpp"
#include "modelfiles/metrics_file.hpp"
#include "pages/plain_page.hpp"
#include "pages/report_data.hpp"
#include "report/interactive_page.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

PageKind chosen(const std::optional<PageKind>& asked) {
  if (asked == PageKind::interactive && !has_viewer())
    throw InvalidInput(
        "the interactive page is not part of this build of foramen: npm was not found, or FORAMEN_VIEWER was "
        "off");
  return asked.value_or(has_viewer() ? PageKind::interactive : PageKind::plain);
}

std::optional<Baseline> read_baseline(const fs::path& folder) {
  if (folder.empty()) return std::nullopt;
  return Baseline{"baseline: " + folder_name(folder), read_metrics_of_shapes(folder)};
}

std::string megabytes(std::size_t bytes) { return fixed(static_cast<double>(bytes) / 1e6, 1) + " MB"; }

}  // namespace

ModelPage model_page(const ModelRecord& record, const PageOptions& options) {
  const PageKind kind = chosen(options.kind);
  const PageContents contents = page_contents(record, read_baseline(options.baseline));
  if (kind == PageKind::plain) {
    const std::string why =
        has_viewer() ? "it was asked for"
                     : "this foramen was built without the interactive one (no npm, or FORAMEN_VIEWER off)";
    ModelPage page{kind, plain_page(record, contents, why), ""};
    page.remark = "plain page, since " + why + "; " + megabytes(page.html.size());
    return page;
  }
  // File names may be no UTF-8; a page must be.
  const std::string data =
      report_data(record, contents).dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  ModelPage page{kind, interactive_html(data), ""};
  page.remark =
      "interactive page; " + megabytes(page.html.size()) + ", " + megabytes(data.size()) + " of them data";
  return page;
}

ModelPage model_page(const fs::path& folder, const PageOptions& options) {
  return model_page(read_model_record(folder), options);
}

std::string model_summary(const RunRecord& run, const Evaluation& evaluation) {
  std::string text;
  for (const std::string& line : summary_lines(run, evaluation)) text += (text.empty() ? "" : "\n") + line;
  return text;
}

}  // namespace foramen
