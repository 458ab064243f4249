#include "findings/mark_findings.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "evaluate/paired_p_value.hpp"
#include "evaluate/subject_pairs.hpp"

namespace foramen {
namespace {

constexpr int mm_digits = 3, dice_digits = 4;

using Pair = std::pair<int, int>;

// The estimates of one evaluation by row, in order.
using Column = std::vector<std::pair<std::string, TransferEstimate>>;

Column points_of(const Evaluation& e) {
  Column column;
  if (!e.marks) return column;
  if (e.marks->points) column.emplace_back("all", e.marks->points->error);
  for (const PointTransfer& p : e.marks->by_point)
    column.emplace_back(p.part == MarkPart::point ? p.mark : p.mark + ", " + std::string(word_of(p.part)),
                        p.error);
  return column;
}

Column curves_of(const Evaluation& e) {
  Column column;
  if (!e.marks) return column;
  if (e.marks->curves) column.emplace_back("all", e.marks->curves->error);
  for (const CurveTransfer& c : e.marks->by_curve) column.emplace_back(c.mark, c.error);
  return column;
}

Column regions_of(const Evaluation& e) {
  Column column;
  if (!e.regions) return column;
  column.emplace_back("all", e.regions->dice);
  for (const RegionOverlap& r : e.regions->by_region) column.emplace_back(r.region, r.dice);
  return column;
}

// A row per name that any evaluation has.
ReportTable table_of(const std::string& title, const std::string& note, const char* first_column, int digits,
                     const std::vector<NamedEvaluation>& evaluations,
                     const std::function<Column(const Evaluation&)>& column_of) {
  ReportTable table{title, note, {first_column}, {}};
  std::vector<std::string> names;
  std::vector<std::map<std::string, TransferEstimate>> columns;
  for (const NamedEvaluation& named : evaluations) {
    table.header.push_back(named.name);
    columns.emplace_back();
    for (const auto& [name, estimate] : column_of(*named.evaluation)) {
      columns.back()[name] = estimate;
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  for (const std::string& name : names) {
    std::vector<std::string> row{name};
    for (const auto& column : columns) {
      const auto found = column.find(name);
      row.push_back(found == column.end() ? "-" : fixed(found->second, digits));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

// The values of pairs by their shapes.
std::map<Pair, double> point_values(const Evaluation& e) {
  std::map<Pair, double> values;
  if (e.marks)
    for (const MarkPair& p : e.marks->pairs)
      if (p.points) values[{p.from, p.to}] = *p.points;
  return values;
}
std::map<Pair, double> curve_values(const Evaluation& e) {
  std::map<Pair, double> values;
  if (e.marks)
    for (const MarkPair& p : e.marks->pairs)
      if (p.curves) values[{p.from, p.to}] = *p.curves;
  return values;
}
std::map<Pair, double> dice_values(const Evaluation& e) {
  std::map<Pair, double> values;
  if (e.regions)
    for (const RegionPair& p : e.regions->pairs) values[{p.from, p.to}] = p.dice;
  return values;
}

std::vector<detail::PairValue> differences_of(const std::map<Pair, double>& first,
                                              const std::map<Pair, double>& second,
                                              const std::vector<std::size_t>& partner) {
  std::vector<detail::PairValue> differences;
  for (const auto& [pair, value] : first) {
    const auto found =
        second.find({static_cast<int>(partner[pair.first]), static_cast<int>(partner[pair.second])});
    if (found != second.end()) differences.push_back({pair.first, pair.second, found->second - value});
  }
  return differences;
}

std::string note_of(const std::vector<detail::PairValue>& differences, std::size_t signs,
                    const std::string& unit, bool less_is_better) {
  const auto better = std::count_if(differences.begin(), differences.end(), [&](const detail::PairValue& d) {
    return less_is_better ? d.value < 0 : d.value > 0;
  });
  return "mean ± standard error (jackknife over subjects) over " + std::to_string(differences.size()) +
         " ordered pairs, " + unit + "; the second is better in " + std::to_string(better) +
         "; p: two-sided, sign flips of the " + std::to_string(signs) + " subjects from which pairs start";
}

DifferenceGroup group_of(const std::string& name, const std::string& measure, const std::string& unit,
                         bool less_is_better, const std::vector<detail::PairValue>& differences,
                         const detail::PairSubjects& subjects) {
  std::map<int, double> sum_of;  // by the subject from which pairs start
  for (const detail::PairValue& d : differences) sum_of[subjects.of(d.from)] += d.value;
  std::vector<double> sums;
  for (const auto& [subject, sum] : sum_of) sums.push_back(sum);
  const TransferEstimate mean = detail::mean_over_pairs(differences, subjects);
  const Estimate difference{mean.mean,
                            mean.standard_error.value_or(std::numeric_limits<double>::quiet_NaN())};
  return {name,
          note_of(differences, sums.size(), unit, less_is_better),
          {{measure, {{std::nullopt, difference, paired_p_value(sums)}}}},
          unit};
}

}  // namespace

std::string fixed(const TransferEstimate& value, int digits) {
  return value.standard_error ? fixed(Estimate{value.mean, *value.standard_error}, digits)
                              : fixed(value.mean, digits);
}

std::vector<std::string> mark_lines(const Evaluation& e) {
  std::vector<std::string> lines;
  const auto add = [&](const char* what, const std::optional<TransferSummary>& summary) {
    if (summary)
      lines.push_back(std::string("marks, ") + what + ": mean " + fixed(summary->error, mm_digits) +
                      " mm, p95 " + fixed(summary->p95, 2) + " mm (" + std::to_string(summary->errors) +
                      " transfers, " + std::to_string(summary->error.pairs) + " pairs of " +
                      std::to_string(e.marks->marked_shapes) + " shapes" +
                      (e.marks->incomplete_shapes > 0
                           ? ", of which " + std::to_string(e.marks->incomplete_shapes) + " lack some marks)"
                           : ")"));
  };
  if (e.marks) {
    add("points", e.marks->points);
    add("curves", e.marks->curves);
  }
  if (e.regions)
    lines.push_back("regions: mean Dice " + fixed(e.regions->dice, dice_digits) + " (" +
                    std::to_string(e.regions->by_region.size()) + " regions, " +
                    std::to_string(e.regions->dice.pairs) + " pairs of " +
                    std::to_string(e.regions->labelled_shapes) + " shapes)");
  return lines;
}

std::vector<ReportTable> mark_tables(const std::vector<NamedEvaluation>& evaluations) {
  const std::string mm = "mean ± standard error over subjects, mm; no error for fewer than three subjects";
  std::vector<ReportTable> tables{
      table_of("Curves that people marked", mm, "curve", mm_digits, evaluations, curves_of),
      table_of("Points that people marked", mm, "point", mm_digits, evaluations, points_of),
      table_of("Regions that people marked", "Dice coefficient, as the errors of marks", "region",
               dice_digits, evaluations, regions_of)};
  std::erase_if(tables, [](const ReportTable& table) { return table.rows.empty(); });
  return tables;
}

std::vector<DifferenceGroup> mark_differences(const Evaluation& first, const Evaluation& second,
                                              const std::vector<std::size_t>& partner) {
  const detail::PairSubjects subjects(static_cast<int>(first.names.size()), first.subjects);
  std::vector<DifferenceGroup> groups;
  const auto add = [&](const char* name, const char* measure, const char* unit, bool less_is_better,
                       std::map<Pair, double> (*values_of)(const Evaluation&)) {
    const auto differences = differences_of(values_of(first), values_of(second), partner);
    if (!differences.empty())
      groups.push_back(group_of(name, measure, unit, less_is_better, differences, subjects));
  };
  add("Marks, points", "mean", "mm", true, point_values);
  add("Marks, curves", "mean", "mm", true, curve_values);
  add("Regions", "Dice", "share", false, dice_values);
  return groups;
}

}  // namespace foramen
