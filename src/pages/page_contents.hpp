#pragma once

#include <optional>
#include <string>
#include <vector>

#include "findings/plain_words.hpp"
#include "modelfiles/model_record.hpp"
#include "pages/page_marks.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// The model with which the page compares its model.
struct Baseline {
  std::string name;
  Evaluation evaluation;  ///< with the values of each shape
};

/// The contents that both kinds of page have in common.
struct PageContents {
  std::string title, subtitle;
  std::vector<Statement> plain_words;
  std::vector<std::string> findings;     ///< one line each
  std::vector<Chart> charts;             ///< curves of the model and of the baseline
  std::vector<PageMark> marks;           ///< none if nothing was marked
  std::vector<ReportTable> figures;      ///< of marks and regions, and the numbers of the charts
  std::vector<ReportTable> differences;  ///< differences to the baseline; empty without one
  std::vector<std::string> remarks;      ///< on the differences
  ReportTable shapes, left_out, repaired, refit_failures;
  std::string made_by;
  ReportTable options, inputs, papers;
};
PageContents page_contents(const ModelRecord& record, const std::optional<Baseline>& baseline);

}  // namespace foramen
