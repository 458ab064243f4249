#pragma once

#include <filesystem>

#include "foramen/evaluate/evaluate.hpp"
#include "report/report_page.hpp"

namespace foramen {

/// The name of a model: the last part of its folder's path, also if the path ends in a slash or is ".".
std::string folder_name(const std::filesystem::path& model);

/// An evaluation and its name, which labels its curve in a chart.
struct NamedEvaluation {
  std::string name;
  const Evaluation* evaluation = nullptr;
};

/// Charts of generalization and specificity (Hausdorff and mean surface), compactness, and the paper's
/// ensemble form over the number of modes, with standard errors. Each chart has one curve per evaluation.
/// Charts of refits come last and exist if one of the evaluations has a refit.
std::vector<Chart> model_charts(const std::vector<NamedEvaluation>& evaluations);

/// The figures of those charts as tables.
std::vector<ReportTable> model_tables(const std::vector<NamedEvaluation>& evaluations);

/// The errors at the number of modes at which single figures are quoted: 8, or the largest number below 8.
/// Null if the list is empty.
const ErrorsAtModes* at_quoted_modes(const std::vector<ErrorsAtModes>& by_modes);

/// The number in fixed-point notation.
std::string fixed(double value, int digits);
/// mean +- standard error; the mean alone if the error is NaN.
std::string fixed(const Estimate& value, int digits);
/// The share as a percentage: "mean ± standard error %".
std::string percent(const Estimate& share);

/// A sentence about the quality of the drawn shapes.
std::string drawn_shapes_line(const DrawnShapes& drawn);

}  // namespace foramen
