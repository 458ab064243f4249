#pragma once
/// \file
/// Differences of two models in the measures, paired over shapes if possible.

#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "findings/model_report.hpp"

namespace foramen {

struct DifferenceAtModes {
  std::optional<int> modes;  ///< unset: the measure does not depend on it
  /// Second model minus first, in the unit of the group. The standard error is NaN if it is not known.
  Estimate difference;
  std::optional<double> p_value;  ///< for paired differences; unset if not paired
};

struct MeasureDifference {
  std::string name;
  std::vector<DifferenceAtModes> by_modes;  ///< for the numbers of modes that both models have
};

/// Measures that are shown in one table.
struct DifferenceGroup {
  std::string name, note;
  std::vector<MeasureDifference> measures;
  std::string unit = "mm";
};

struct ModelDifference {
  std::string first, second;
  std::string why_not_paired;  ///< empty if the differences are paired
  std::vector<DifferenceGroup> groups;
};

/// Leave-one-out generalization and representation are paired over shapes: the result has the mean
/// difference, its standard error s / sqrt(n), and paired_p_value(). Leave-one-subject-out generalization
/// is paired as well if both models have the same subjects; in its test, all shapes of a subject change
/// sign together. Errors of marks and the overlap of regions are paired over pairs of shapes, see
/// mark_differences(). Specificity is not paired and has the two-sample standard error sqrt(se_1^2 +
/// se_2^2). If the models differ in the names of their shapes or in the treatment of size, only specificity
/// is compared. \pre the evaluations hold the values of each shape (read_metrics_of_shapes())
ModelDifference model_difference(const NamedEvaluation& first, const NamedEvaluation& second);

std::vector<ReportTable> difference_tables(const ModelDifference& difference);
nlohmann::ordered_json difference_json(const ModelDifference& difference);

}  // namespace foramen
