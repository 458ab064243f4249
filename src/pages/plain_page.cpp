#include "pages/plain_page.hpp"

#include "pages/model_pictures.hpp"
#include "render/render_scene.hpp"

namespace foramen {
namespace {

ReportSection summary_section(const PageContents& contents) {
  ReportSection section{.title = "Summary", .findings = contents.findings};
  for (const Statement& statement : contents.plain_words)
    section.paragraphs.push_back(statement.heading + ": " + statement.text);
  for (const ReportTable& table : {contents.left_out, contents.repaired, contents.refit_failures})
    if (!table.rows.empty()) section.tables.push_back(table);
  return section;
}

ReportSection pictures_section(const ModelRecord& record, const PageContents& contents) {
  if (can_render()) {
    ReportSection section{.title = "Pictures", .pictures = model_pictures(record.atlas, record.loaded.model)};
    section.pictures.push_back(mean_distance_picture(record.loaded.model, record.error_maps));
    if (!contents.marks.empty())
      section.pictures.push_back(marks_picture(record.loaded.model, contents.marks));
    return section;
  }
  return {
      .title = "Pictures",
      .paragraphs = {
          "None: this build has no VTK, or there was no display. With libvtk9-dev installed at "
          "build time, the plain page has pictures where it is written with a display or under xvfb-run -a."}};
}

}  // namespace

std::string plain_page(const ModelRecord& record, const PageContents& contents, const std::string& why) {
  ReportPage page{contents.title, contents.subtitle, {}};
  page.sections.push_back(summary_section(contents));
  page.sections.push_back(pictures_section(record, contents));
  page.sections.push_back(
      {.title = "Evaluation",
       .paragraphs =
           {"Distances are measured to the input surfaces (repaired where it says so). Bars are standard "
            "errors of the mean. Specificity alone rewards a model that lost variance: read it beside the "
            "total variance and the representation error."},
       .charts = contents.charts});
  if (!contents.differences.empty())
    page.sections.push_back({.title = "This model minus the baseline",
                             .paragraphs = contents.remarks,
                             .tables = contents.differences});
  page.sections.push_back({.title = "Shapes", .tables = {contents.shapes}});
  page.sections.push_back({.title = "Figures", .tables = contents.figures});
  page.sections.push_back({.title = "How it was made",
                           .paragraphs = {contents.made_by, "This is the plain page: " + why + "."},
                           .tables = {contents.papers, contents.options, contents.inputs}});
  return report_html(page);
}

}  // namespace foramen
