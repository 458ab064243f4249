#pragma once

#include <string>
#include <vector>

#include "foramen/evaluate/evaluate.hpp"
#include "modelfiles/run_file.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// The figures of a model that are quoted first, a line each.
std::vector<std::string> summary_lines(const RunRecord& run, const Evaluation& evaluation);

/// Representation and flips, a row a shape.
ReportTable shapes_table(const RunRecord& run, const Evaluation& evaluation);
/// Inputs that are not in the model, and why; without rows if there are none.
ReportTable left_out_table(const RunRecord& run);
ReportTable repairs_table(const RunRecord& run);
/// Shapes that failed in a refit, and why; without rows if there are none.
ReportTable refit_failures_table(const Evaluation& evaluation);

/// How the model was made: nothing that differs from run to run.
ReportTable options_table(const RunRecord& run);
ReportTable inputs_table(const RunRecord& run);
ReportTable papers_table(const RunRecord& run);
/// The version of the program and its command.
std::string made_by(const RunRecord& run);

}  // namespace foramen
