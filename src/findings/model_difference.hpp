#pragma once
/// \file
/// What one model is better or worse by than another, shape by shape where that is possible.

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "findings/model_report.hpp"

namespace foramen {

struct DifferenceAtModes {
  std::optional<int> modes;       ///< unset: the measure does not depend on it
  Estimate difference;            ///< second model minus first, mm
  std::optional<double> p_value;  ///< of the paired differences; unset: not paired
};

struct MeasureDifference {
  std::string name;
  std::vector<DifferenceAtModes> by_modes;  ///< the numbers of modes that both models have
};

/// Measures that belong in one table.
struct DifferenceGroup {
  std::string name, note;
  std::vector<MeasureDifference> measures;
};

struct ModelDifference {
  std::string first, second;
  std::string why_not_paired;  ///< empty: paired
  std::vector<DifferenceGroup> groups;
};

/// Paired over shapes: generalization, leave one out, and representation: mean difference, its standard error
/// s / sqrt(n), and paired_p_value(); and leave one subject out, where both know the same subjects: there the
/// shapes of a subject change sign together. Not paired: specificity, with the two-sample standard error
/// sqrt(se_1^2 + se_2^2). Without the same names of shapes, or the same treatment of size, specificity alone.
/// \pre the evaluations hold the items of shapes (read_metrics_of_shapes)
ModelDifference model_difference(const NamedEvaluation& first, const NamedEvaluation& second);

std::vector<ReportTable> difference_tables(const ModelDifference& difference);
nlohmann::ordered_json difference_json(const ModelDifference& difference);

}  // namespace foramen
