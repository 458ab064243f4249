#include "pages/page_contents.hpp"

#include "findings/mark_findings.hpp"
#include "findings/model_difference.hpp"
#include "findings/model_findings.hpp"
#include "findings/model_report.hpp"

namespace foramen {
namespace {

std::vector<ReportTable> figures_of(const std::vector<NamedEvaluation>& evaluations,
                                    const std::vector<PageMark>& marks) {
  std::vector<ReportTable> tables = mark_tables(evaluations);
  if (!marks.empty()) tables.push_back(scatter_table(marks));
  for (ReportTable& table : model_tables(evaluations)) tables.push_back(std::move(table));
  return tables;
}

}  // namespace

PageContents page_contents(const ModelRecord& record, const std::optional<Baseline>& baseline) {
  const Evaluation& evaluation = record.evaluation;
  std::vector<NamedEvaluation> curves{{"this model", &evaluation}};
  if (baseline) curves.push_back({baseline->name, &baseline->evaluation});
  PageContents page{.title = "Statistical shape model",
                    .subtitle = std::to_string(evaluation.names.size()) + " vertebrae, " +
                                std::to_string(evaluation.landmarks) + " landmarks, " +
                                std::to_string(record.loaded.model.modes()) + " modes",
                    .plain_words = in_plain_words(record),
                    .findings = summary_lines(record.run, evaluation),
                    .charts = model_charts(curves),
                    .marks = page_marks(record),
                    .figures = {},
                    .differences = {},
                    .remarks = {},
                    .shapes = shapes_table(record.run, evaluation),
                    .left_out = left_out_table(record.run),
                    .repaired = repairs_table(record.run),
                    .refit_failures = refit_failures_table(evaluation),
                    .made_by = made_by(record.run),
                    .options = options_table(record.run),
                    .inputs = inputs_table(record.run),
                    .papers = papers_table(record.run)};
  page.figures = figures_of(curves, page.marks);
  if (baseline) {
    const ModelDifference difference = model_difference(curves[1], curves[0]);
    page.differences = difference_tables(difference);
    for (std::size_t i = 0; i < page.differences.size(); ++i)
      page.differences[i].title = difference.groups[i].name;  // the section's heading names the models
    if (!difference.why_not_paired.empty())
      page.remarks.push_back("The two models are not paired: " + difference.why_not_paired + ".");
  }
  return page;
}

}  // namespace foramen
