#include "findings/model_report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

namespace foramen {
namespace {

// A point of the curve of one measure over the number of modes.
struct CurvePoint {
  int modes;
  Estimate value;
};
struct Measure {
  std::string file_stem, title, y_label;
  bool is_mean = true;  // whether the measure is a mean of distances in mm, with a standard error
  std::function<std::vector<CurvePoint>(const Evaluation&)> points;
};

std::vector<CurvePoint> of_errors(const std::vector<ErrorsAtModes>& errors, Estimate ErrorsAtModes::*which) {
  std::vector<CurvePoint> out;
  for (const ErrorsAtModes& e : errors) out.push_back({e.modes, e.*which});
  return out;
}

std::vector<CurvePoint> of_refit(const std::optional<RefitGeneralization>& refit,
                                 Estimate ErrorsAtModes::*which) {
  return refit ? of_errors(refit->generalization.by_modes, which) : std::vector<CurvePoint>();
}

const std::vector<Measure>& measures() {
  static const std::vector<Measure> all{
      {"generalization", "Generalization, Hausdorff (leave one out)", "Hausdorff distance, mm", true,
       [](const Evaluation& e) { return of_errors(e.leave_one_out.by_modes, &ErrorsAtModes::hausdorff); }},
      {"specificity", "Specificity, Hausdorff", "Hausdorff distance, mm", true,
       [](const Evaluation& e) { return of_errors(e.specificity.by_modes, &ErrorsAtModes::hausdorff); }},
      {"generalization_mean", "Generalization, mean surface (leave one out)", "mean surface distance, mm",
       true,
       [](const Evaluation& e) { return of_errors(e.leave_one_out.by_modes, &ErrorsAtModes::mean_surface); }},
      {"specificity_mean", "Specificity, mean surface", "mean surface distance, mm", true,
       [](const Evaluation& e) { return of_errors(e.specificity.by_modes, &ErrorsAtModes::mean_surface); }},
      {"ensemble_generalization", "Generalization, ensemble form (in-sample)", "Hausdorff distance, mm", true,
       [](const Evaluation& e) {
         std::vector<CurvePoint> out;
         for (const EnsembleAtModes& m : e.ensemble) out.push_back({m.modes, m.generalization});
         return out;
       }},
      {"compactness", "Compactness (share of the variance)", "share of the total variance", false,
       [](const Evaluation& e) {
         std::vector<CurvePoint> out;
         for (const CompactnessAtModes& m : e.compactness) out.push_back({m.modes, {m.fraction, 0}});
         return out;
       }},
      {"refit_generalization", "Generalization, Hausdorff (refit, leave one shape out)",
       "Hausdorff distance, mm", true,
       [](const Evaluation& e) { return of_refit(e.refit, &ErrorsAtModes::hausdorff); }},
      {"refit_generalization_mean", "Generalization, mean surface (refit, leave one shape out)",
       "mean surface distance, mm", true,
       [](const Evaluation& e) { return of_refit(e.refit, &ErrorsAtModes::mean_surface); }},
      {"refit_subject_generalization", "Generalization, Hausdorff (refit, leave one subject out)",
       "Hausdorff distance, mm", true,
       [](const Evaluation& e) { return of_refit(e.refit_by_subject, &ErrorsAtModes::hausdorff); }},
      {"refit_subject_generalization_mean", "Generalization, mean surface (refit, leave one subject out)",
       "mean surface distance, mm", true,
       [](const Evaluation& e) { return of_refit(e.refit_by_subject, &ErrorsAtModes::mean_surface); }},
  };
  return all;
}

// The measures that at least one of these models has.
std::vector<Measure> measures_of(const std::vector<NamedEvaluation>& evaluations) {
  std::vector<Measure> measured;
  for (const Measure& measure : measures())
    if (std::any_of(evaluations.begin(), evaluations.end(),
                    [&](const NamedEvaluation& e) { return !measure.points(*e.evaluation).empty(); }))
      measured.push_back(measure);
  return measured;
}

}  // namespace

std::string folder_name(const std::filesystem::path& model) {
  const auto normal = std::filesystem::absolute(model).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).filename().string();
}

const ErrorsAtModes* at_quoted_modes(const std::vector<ErrorsAtModes>& by_modes) {
  constexpr int quoted_modes = 8;
  const ErrorsAtModes* best = nullptr;
  for (const ErrorsAtModes& e : by_modes)
    if (e.modes <= quoted_modes) best = &e;
  return best;
}

std::string fixed(double value, int digits) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string fixed(const Estimate& value, int digits) {
  return std::isnan(value.standard_error)
             ? fixed(value.mean, digits)
             : fixed(value.mean, digits) + " ± " + fixed(value.standard_error, digits);
}

std::string percent(const Estimate& share) {
  return fixed(Estimate{100 * share.mean, 100 * share.standard_error}, 1) + " %";
}

std::string drawn_shapes_line(const DrawnShapes& drawn) {
  return "drawn shapes, all scores within " + fixed(largest_drawn_sd, 0) +
         " sd: " + percent(drawn.self_intersecting) + " intersect themselves, " + percent(drawn.folded) +
         " have a triangle folded over, " + percent(drawn.opposing_mean) + " one turned against the mean's";
}

std::vector<Chart> model_charts(const std::vector<NamedEvaluation>& evaluations) {
  std::vector<Chart> charts;
  for (const Measure& measure : measures_of(evaluations)) {
    Chart chart{measure.title, "number of modes", measure.y_label, {}, measure.file_stem};
    for (const NamedEvaluation& named : evaluations) {
      ChartSeries series{named.name, {}, {}, {}};
      for (const CurvePoint& p : measure.points(*named.evaluation)) {
        series.x.push_back(p.modes);
        series.y.push_back(p.value.mean);
        series.error.push_back(p.value.standard_error);
      }
      chart.series.push_back(std::move(series));
    }
    charts.push_back(std::move(chart));
  }
  return charts;
}

std::vector<ReportTable> model_tables(const std::vector<NamedEvaluation>& evaluations) {
  std::vector<ReportTable> tables;
  for (const Measure& measure : measures_of(evaluations)) {
    ReportTable table{measure.title, measure.is_mean ? "mean ± standard error, mm" : "", {"modes"}, {}};
    std::size_t longest = 0;
    std::vector<std::vector<CurvePoint>> columns;
    for (const NamedEvaluation& named : evaluations) {
      table.header.push_back(named.name);
      columns.push_back(measure.points(*named.evaluation));
      longest = std::max(longest, columns.back().size());
    }
    for (std::size_t i = 0; i < longest; ++i) {
      std::vector<std::string> row{""};
      for (const auto& column : columns) {
        if (i < column.size()) row[0] = std::to_string(column[i].modes);
        row.push_back(i >= column.size() ? ""
                      : measure.is_mean  ? fixed(column[i].value, 3)
                                         : fixed(column[i].value.mean, 3));
      }
      table.rows.push_back(std::move(row));
    }
    tables.push_back(std::move(table));
  }
  return tables;
}

}  // namespace foramen
