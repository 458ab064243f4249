#pragma once

#include <optional>
#include <string>
#include <vector>

#include "findings/plain_words.hpp"
#include "modelfiles/model_record.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// A model to compare with.
struct Baseline {
  std::string name;
  Evaluation evaluation;  ///< with the items of shapes
};

/// What both kinds of page say of a model.
struct PageContents {
  std::string title, subtitle;
  std::vector<Statement> plain_words;
  std::vector<std::string> findings;     ///< a line each
  std::vector<Chart> charts;             ///< of the model, and of the baseline
  std::vector<ReportTable> figures;      ///< of the charts
  std::vector<ReportTable> differences;  ///< to the baseline; none without one
  std::vector<std::string> remarks;      ///< on the differences
  ReportTable shapes, left_out, repaired, refit_failures;
  std::string made_by;
  ReportTable options, inputs, papers;
};
PageContents page_contents(const ModelRecord& record, const std::optional<Baseline>& baseline);

}  // namespace foramen
