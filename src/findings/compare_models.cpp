#include "findings/compare_models.hpp"

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

#include <nlohmann/json.hpp>

#include "findings/mark_findings.hpp"
#include "findings/model_difference.hpp"
#include "findings/model_report.hpp"
#include "modelfiles/metrics_file.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

// A model has the name of its folder. If two folders have the same name, their paths are used as given.
std::vector<std::string> names_of(const std::vector<fs::path>& models) {
  std::vector<std::string> names, given;
  for (const fs::path& model : models) {
    names.push_back(folder_name(model));
    given.push_back(model.string());
  }
  const bool all_differ = std::set<std::string>(names.begin(), names.end()).size() == names.size();
  return all_differ ? names : given;
}

std::string padded(const std::string& text, std::size_t width) {
  const std::size_t letters = std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; });
  return text + std::string(width > letters ? width - letters : 1, ' ');
}

std::string table_text(const ReportTable& table) {
  constexpr std::size_t first_column = 10, column = 20, p_column = 10;
  std::string out = table.title + (table.note.empty() ? "" : " (" + table.note + ")") + "\n";
  const auto add_row = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i)
      out += padded(row[i], i == 0 ? first_column : table.header[i] == "p" ? p_column : column);
    out += "\n";
  };
  add_row(table.header);
  for (const auto& row : table.rows) add_row(row);
  return out + "\n";
}

// A row of the table: its title, and the text for a model. Each model has a column.
using Figure = std::pair<std::string, std::function<std::string(const Evaluation&)>>;

ReportTable figures(const std::string& title, const std::string& note,
                    const std::vector<NamedEvaluation>& models, const std::vector<Figure>& rows) {
  ReportTable table{title, note, {""}, {}};
  for (const NamedEvaluation& model : models) table.header.push_back(model.name);
  for (const auto& [name, value] : rows) {
    std::vector<std::string> row{name};
    for (const NamedEvaluation& model : models) row.push_back(value(*model.evaluation));
    table.rows.push_back(std::move(row));
  }
  return table;
}

ReportTable single_figures(const std::vector<NamedEvaluation>& models) {
  return figures(
      "Representation and flips", "per shape", models,
      {{"landmarks", [](const Evaluation& e) { return std::to_string(e.landmarks); }},
       {"weights", [](const Evaluation& e) { return std::string(word_of(e.options.weights)); }},
       {"mean", [](const Evaluation& e) { return fixed(e.representation.mean_surface, 3); }},
       {"p95", [](const Evaluation& e) { return fixed(e.representation.p95, 3); }},
       {"Hausd.", [](const Evaluation& e) { return fixed(e.representation.hausdorff, 2); }},
       {"plain", [](const Evaluation& e) { return fixed(e.representation.plain_flips, 1); }},
       {"conf.", [](const Evaluation& e) { return fixed(e.representation.confirmed_flips, 1); }},
       {"opp.mean", [](const Evaluation& e) { return fixed(e.representation.opposing_mean, 1); }},
       {"self-int.", [](const Evaluation& e) { return fixed(e.representation.self_intersections, 1); }},
       {"of input", [](const Evaluation& e) { return fixed(e.representation.input_self_intersections, 1); }},
       {"variance", [](const Evaluation& e) { return fixed(e.total_variance, 3); }},
       {"truth", [](const Evaluation& e) { return e.truth ? fixed(e.truth->error.mean, 3) : "-"; }},
       {"truth95", [](const Evaluation& e) { return e.truth ? fixed(e.truth->error.p95, 3) : "-"; }}});
}

// A model that lost variance or detail has a low specificity. Therefore, the table shows specificity together
// with variance and representation error.
ReportTable specificity_in_context(const std::vector<NamedEvaluation>& models) {
  const auto specificity = [](Estimate ErrorsAtModes::*which) {
    return [which](const Evaluation& e) {
      const ErrorsAtModes* quoted = at_quoted_modes(e.specificity.by_modes);
      return quoted != nullptr ? fixed(quoted->*which, 3) : "-";
    };
  };
  return figures(
      "Specificity beside what it may have cost",
      "specificity, mm; total variance, mm^2 a landmark; representation error, mm; drawn shapes that "
      "intersect themselves, have a triangle folded over or one opposing the mean's",
      models,
      {{"modes",
        [](const Evaluation& e) {
          const ErrorsAtModes* quoted = at_quoted_modes(e.specificity.by_modes);
          return quoted != nullptr ? std::to_string(quoted->modes) : "-";
        }},
       {"Hausd.", specificity(&ErrorsAtModes::hausdorff)},
       {"mean", specificity(&ErrorsAtModes::mean_surface)},
       {"variance", [](const Evaluation& e) { return fixed(e.total_variance, 3); }},
       {"repr.mean", [](const Evaluation& e) { return fixed(e.representation.mean_surface, 3); }},
       {"repr.Hd.", [](const Evaluation& e) { return fixed(e.representation.hausdorff, 2); }},
       {"self-int.", [](const Evaluation& e) { return percent(e.drawn.self_intersecting); }},
       {"folded", [](const Evaluation& e) { return percent(e.drawn.folded); }},
       {"opp.mean", [](const Evaluation& e) { return percent(e.drawn.opposing_mean); }}});
}

ordered_json as_json(const std::vector<NamedEvaluation>& models, const std::vector<ReportTable>& tables) {
  ordered_json out = ordered_json::object();
  for (std::size_t k = 0; k < models.size(); ++k)
    for (const ReportTable& table : tables)
      for (const auto& row : table.rows) out[models[k].name][table.title][row[0]] = row[k + 1];
  return out;
}

}  // namespace

ModelComparison compare_models(const std::vector<fs::path>& models) {
  std::vector<Evaluation> evaluations;
  evaluations.reserve(models.size());
  for (const fs::path& model : models) evaluations.push_back(read_metrics_of_shapes(model));
  const std::vector<std::string> names = names_of(models);
  std::vector<NamedEvaluation> named;
  for (std::size_t i = 0; i < models.size(); ++i) named.push_back({names[i], &evaluations[i]});

  std::vector<ReportTable> tables = model_tables(named);
  tables.insert(tables.begin(), {single_figures(named), specificity_in_context(named)});
  for (ReportTable& table : mark_tables(named)) tables.push_back(std::move(table));
  const std::vector<Chart> charts = model_charts(named);

  ModelComparison comparison;
  for (const ReportTable& table : tables) comparison.text += table_text(table);
  ordered_json json = as_json(named, tables);
  ReportSection differences{.title = "Differences"};
  for (std::size_t i = 1; i < named.size(); ++i) {
    const ModelDifference difference = model_difference(named.front(), named[i]);
    if (!difference.why_not_paired.empty()) {
      differences.paragraphs.push_back(difference.second + " and " + difference.first +
                                       " are not paired: " + difference.why_not_paired + ".");
      comparison.text += differences.paragraphs.back() + "\n\n";
    }
    for (ReportTable& table : difference_tables(difference)) {
      comparison.text += table_text(table);
      differences.tables.push_back(std::move(table));
    }
    json["differences"].push_back(difference_json(difference));
  }
  comparison.json = json.dump(2);
  ReportPage page{"Comparison of models",
                  "",
                  {{.title = "Curves", .charts = charts},
                   std::move(differences),
                   {.title = "Figures", .tables = tables}}};
  for (const NamedEvaluation& model : named)
    page.subtitle += (page.subtitle.empty() ? "" : ", ") + model.name;
  comparison.html = report_html(page);
  for (const Chart& chart : charts)
    comparison.charts.emplace_back(chart.file_stem + ".svg", svg_chart_file(chart));
  return comparison;
}

}  // namespace foramen
