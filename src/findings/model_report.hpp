#pragma once

#include <filesystem>

#include "foramen/evaluate/evaluate.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// What a model is called: the last part of its folder's path, also where it ends in a slash or is ".".
std::string folder_name(const std::filesystem::path& model);

/// A named evaluation, as a curve in a chart.
struct NamedEvaluation {
  std::string name;
  const Evaluation* evaluation = nullptr;
};

/// Generalization and specificity (Hausdorff and mean surface), compactness, and the paper's ensemble form,
/// against the number of modes, with standard errors: one curve per evaluation. Those of refits come last,
/// where one of the evaluations has them.
std::vector<Chart> model_charts(const std::vector<NamedEvaluation>& evaluations);

/// The figures of those charts as tables.
std::vector<ReportTable> model_tables(const std::vector<NamedEvaluation>& evaluations);

/// The errors at the number of modes at which single figures are quoted: 8, or the largest below. None: null.
const ErrorsAtModes* at_quoted_modes(const std::vector<ErrorsAtModes>& by_modes);

/// A number in fixed point.
std::string fixed(double value, int digits);
/// mean +- standard error.
std::string fixed(const Estimate& value, int digits);
/// A share as percentage, mean +- standard error.
std::string percent(const Estimate& share);

/// The quality of the shapes a model describes, in a sentence.
std::string drawn_shapes_line(const DrawnShapes& drawn);

}  // namespace foramen
