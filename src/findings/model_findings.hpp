#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "foramen/evaluate/evaluate.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// The figures of a model that are quoted first, a line each. \param run  the contents of run.json
std::vector<std::string> summary_lines(const nlohmann::ordered_json& run, const Evaluation& evaluation);

/// Representation and flips, a row a shape.
ReportTable shapes_table(const nlohmann::ordered_json& run, const Evaluation& evaluation);
/// Inputs that are not in the model, and why; without rows if there are none.
ReportTable left_out_table(const nlohmann::ordered_json& run);
ReportTable repairs_table(const nlohmann::ordered_json& run);
/// Shapes that failed in a refit, and why; without rows if there are none.
ReportTable refit_failures_table(const Evaluation& evaluation);

/// How the model was made: nothing that differs from run to run.
ReportTable options_table(const nlohmann::ordered_json& run);
ReportTable inputs_table(const nlohmann::ordered_json& run);
ReportTable papers_table(const nlohmann::ordered_json& run);
/// The version of the program and its command.
std::string made_by(const nlohmann::ordered_json& run);

}  // namespace foramen
