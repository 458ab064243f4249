#include "findings/model_difference.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "evaluate/paired_p_value.hpp"
#include "findings/mark_findings.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

// For each shape of one evaluation, the index of the shape with the same name in another one.
using Partners = std::vector<std::size_t>;

std::string why_not_paired(const NamedEvaluation& first, const NamedEvaluation& second) {
  const auto lacks = [](const NamedEvaluation& a, const NamedEvaluation& b) -> std::string {
    const auto& names = a.evaluation->names;
    for (const std::string& name : b.evaluation->names)
      if (std::find(names.begin(), names.end(), name) == names.end())
        return a.name + " has no shape " + name + ", which " + b.name + " has";
    return {};
  };
  if (std::string lack = lacks(first, second); !lack.empty()) return lack;
  if (std::string lack = lacks(second, first); !lack.empty()) return lack;
  if (first.evaluation->options.scale != second.evaluation->options.scale)
    return "the size of shapes was kept in one and removed in the other";
  return {};
}

Partners partners(const Evaluation& first, const Evaluation& second) {
  Partners found;
  found.reserve(first.names.size());
  for (const std::string& name : first.names)
    found.push_back(static_cast<std::size_t>(std::find(second.names.begin(), second.names.end(), name) -
                                             second.names.begin()));
  return found;
}

bool same_subjects(const Evaluation& first, const Evaluation& second, const Partners& partner) {
  for (std::size_t i = 0; i < partner.size(); ++i)
    if (first.subjects[i] != second.subjects[partner[i]]) return false;
  return true;
}

std::vector<double> sums_by_subject(const std::vector<double>& differences,
                                    const std::vector<std::string>& subjects) {
  std::map<std::string, double> sum_of;
  for (std::size_t i = 0; i < differences.size(); ++i) sum_of[subjects[i]] += differences[i];
  std::vector<double> sums;
  sums.reserve(sum_of.size());
  for (const auto& [subject, sum] : sum_of) sums.push_back(sum);
  return sums;
}

// Calls found(first, second) for every number of modes that both lists contain.
template <class Found>
void at_common_modes(const std::vector<ErrorsAtModes>& first, const std::vector<ErrorsAtModes>& second,
                     const Found& found) {
  for (const ErrorsAtModes& a : first)
    for (const ErrorsAtModes& b : second)
      if (a.modes == b.modes) found(a, b);
}

/// \param subjects  the subject of each shape; empty: every shape is a subject of its own
MeasureDifference paired_generalization(const std::string& name, const Generalization& first,
                                        const Generalization& second, const Partners& partner,
                                        double ShapeError::*error, const std::vector<std::string>& subjects) {
  MeasureDifference measure{name, {}};
  at_common_modes(first.by_modes, second.by_modes, [&](const ErrorsAtModes& a, const ErrorsAtModes& b) {
    std::vector<double> d;
    d.reserve(partner.size());
    for (std::size_t i = 0; i < partner.size(); ++i)
      d.push_back(b.items[partner[i]].*error - a.items[i].*error);
    measure.by_modes.push_back(
        {a.modes, estimate(d), paired_p_value(subjects.empty() ? d : sums_by_subject(d, subjects))});
  });
  return measure;
}

MeasureDifference paired_representation(const std::string& name, const Representation& first,
                                        const Representation& second, const Partners& partner,
                                        double SurfaceDistance::*distance) {
  std::vector<double> d;
  d.reserve(partner.size());
  for (std::size_t i = 0; i < partner.size(); ++i)
    d.push_back(second.shapes[partner[i]].distance.*distance - first.shapes[i].distance.*distance);
  return {name, {{std::nullopt, estimate(d), paired_p_value(d)}}};
}

MeasureDifference two_sample(const std::string& name, const std::vector<ErrorsAtModes>& first,
                             const std::vector<ErrorsAtModes>& second, Estimate ErrorsAtModes::*which) {
  MeasureDifference measure{name, {}};
  at_common_modes(first, second, [&](const ErrorsAtModes& a, const ErrorsAtModes& b) {
    const Estimate &x = a.*which, &y = b.*which;
    measure.by_modes.push_back(
        {a.modes, {y.mean - x.mean, std::hypot(x.standard_error, y.standard_error)}, std::nullopt});
  });
  return measure;
}

std::string paired_note(std::size_t shapes, std::size_t signs, const char* of_what) {
  const bool exact = static_cast<int>(signs) <= most_enumerated_differences;
  return "mean ± standard error over " + std::to_string(shapes) + " shapes, mm; p: two-sided, " +
         (exact ? "all" : "random") + " sign flips of " + std::to_string(signs) + " " + of_what;
}

std::vector<DifferenceGroup> paired_groups(const Evaluation& first, const Evaluation& second) {
  const Partners partner = partners(first, second);
  const std::size_t n = partner.size();
  std::vector<DifferenceGroup> groups;
  const auto add = [&](const char* name, const Generalization& a, const Generalization& b,
                       const std::vector<std::string>& subjects, const std::string& note) {
    groups.push_back(
        {name,
         note,
         {paired_generalization("Hausdorff", a, b, partner, &ShapeError::hausdorff, subjects),
          paired_generalization("mean surface", a, b, partner, &ShapeError::mean_surface, subjects)}});
  };
  add("Generalization (leave one out)", first.leave_one_out, second.leave_one_out, {},
      paired_note(n, n, "shapes"));
  if (first.leave_subject_out && second.leave_subject_out && same_subjects(first, second, partner))
    add("Generalization (leave one subject out)", *first.leave_subject_out, *second.leave_subject_out,
        first.subjects, paired_note(n, first.leave_subject_out->groups, "subjects"));
  const Representation &a = first.representation, &b = second.representation;
  groups.push_back({"Representation",
                    paired_note(n, n, "shapes"),
                    {paired_representation("mean", a, b, partner, &SurfaceDistance::mean),
                     paired_representation("p95", a, b, partner, &SurfaceDistance::p95),
                     paired_representation("Hausdorff", a, b, partner, &SurfaceDistance::hausdorff)}});
  if (first.subjects.empty() == second.subjects.empty() &&
      (first.subjects.empty() || same_subjects(first, second, partner)))
    for (DifferenceGroup& group : mark_differences(first, second, partner))
      groups.push_back(std::move(group));
  return groups;
}

}  // namespace

ModelDifference model_difference(const NamedEvaluation& first, const NamedEvaluation& second) {
  const Evaluation &a = *first.evaluation, &b = *second.evaluation;
  ModelDifference difference{first.name, second.name, why_not_paired(first, second), {}};
  if (difference.why_not_paired.empty()) difference.groups = paired_groups(a, b);
  difference.groups.push_back(
      {"Specificity",
       "difference of the means ± two-sample standard error, mm; the draws of two models are not paired",
       {two_sample("Hausdorff", a.specificity.by_modes, b.specificity.by_modes, &ErrorsAtModes::hausdorff),
        two_sample("mean surface", a.specificity.by_modes, b.specificity.by_modes,
                   &ErrorsAtModes::mean_surface)}});
  return difference;
}

std::vector<ReportTable> difference_tables(const ModelDifference& difference) {
  constexpr int p_digits = 4;
  std::vector<ReportTable> tables;
  for (const DifferenceGroup& group : difference.groups) {
    ReportTable table{
        difference.second + " minus " + difference.first + ": " + group.name, group.note, {"modes"}, {}};
    for (const DifferenceAtModes& at : group.measures.front().by_modes)
      table.rows.push_back({at.modes ? std::to_string(*at.modes) : "-"});
    for (const MeasureDifference& measure : group.measures) {
      const bool paired = !measure.by_modes.empty() && measure.by_modes.front().p_value.has_value();
      table.header.push_back(measure.name);
      if (paired) table.header.emplace_back("p");
      for (std::size_t i = 0; i < measure.by_modes.size(); ++i) {
        const DifferenceAtModes& at = measure.by_modes[i];
        table.rows[i].push_back(fixed(at.difference, 3));
        if (paired) table.rows[i].push_back(fixed(*at.p_value, p_digits));
      }
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

ordered_json difference_json(const ModelDifference& difference) {
  ordered_json measures = ordered_json::array();
  for (const DifferenceGroup& group : difference.groups) {
    const std::string of_unit = "_" + group.unit;
    for (const MeasureDifference& measure : group.measures)
      for (const DifferenceAtModes& at : measure.by_modes)
        measures.push_back({{"measure", group.name + ", " + measure.name},
                            {"modes", at.modes ? ordered_json(*at.modes) : ordered_json()},
                            {"mean" + of_unit, at.difference.mean},
                            {"standard_error" + of_unit, at.difference.standard_error},
                            {"p_value", at.p_value ? ordered_json(*at.p_value) : ordered_json()}});
  }
  return {{"first", difference.first},
          {"second", difference.second},
          {"paired", difference.why_not_paired.empty()},
          {"why_not_paired", difference.why_not_paired},
          {"second_minus_first", measures}};
}

}  // namespace foramen
