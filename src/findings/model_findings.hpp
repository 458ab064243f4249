#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "foramen/evaluate/evaluate.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// The main results of a model, one per line. \param run  the contents of run.json
std::vector<std::string> summary_lines(const nlohmann::ordered_json& run, const Evaluation& evaluation);

/// Representation error and flips, with one row per shape.
ReportTable shapes_table(const nlohmann::ordered_json& run, const Evaluation& evaluation);
/// The inputs that are not in the model, with the reasons. The table has no rows if there are none.
ReportTable left_out_table(const nlohmann::ordered_json& run);
ReportTable repairs_table(const nlohmann::ordered_json& run);
/// The shapes that failed in a refit, with the reasons. The table has no rows if there are none.
ReportTable refit_failures_table(const Evaluation& evaluation);

/// The options of the build. This table and the next two contain nothing that differs between runs, such as
/// times.
ReportTable options_table(const nlohmann::ordered_json& run);
ReportTable inputs_table(const nlohmann::ordered_json& run);
ReportTable papers_table(const nlohmann::ordered_json& run);
/// The version of the program and its command.
std::string made_by(const nlohmann::ordered_json& run);

}  // namespace foramen
