#include "foramen/pipeline/compare_models.hpp"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "foramen/pipeline/metrics_file.hpp"
#include "pipeline/model_report.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string folder_name(const fs::path& model) {
  const fs::path normal = fs::absolute(model).lexically_normal();
  return (normal.has_filename() ? normal : normal.parent_path()).filename().string();
}

std::string padded(const std::string& text, std::size_t width) {
  const auto letters = static_cast<std::size_t>(std::count_if(
      text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
  return text + std::string(width > letters ? width - letters : 1, ' ');
}

std::string table_text(const ReportTable& table) {
  constexpr std::size_t column = 20;
  std::string out = table.title + (table.note.empty() ? "" : " (" + table.note + ")") + "\n";
  const auto add_row = [&](const std::vector<std::string>& row) {
    for (std::size_t i = 0; i < row.size(); ++i) out += padded(row[i], i == 0 ? 8 : column);
    out += "\n";
  };
  add_row(table.header);
  for (const auto& row : table.rows) add_row(row);
  return out + "\n";
}

// Figures that are not curves: one row a figure, one column a model.
ReportTable single_figures(const std::vector<NamedEvaluation>& models) {
  ReportTable table{"Representation and flips", "per shape", {""}, {}};
  for (const NamedEvaluation& model : models) table.header.push_back(model.name);
  const auto add_row = [&](const std::string& name, auto&& value) {
    std::vector<std::string> row{name};
    for (const NamedEvaluation& model : models) row.push_back(value(*model.evaluation));
    table.rows.push_back(std::move(row));
  };
  add_row("landmarks", [](const Evaluation& e) { return std::to_string(e.landmarks); });
  add_row("mean", [](const Evaluation& e) { return fixed(e.representation.mean_surface, 3); });
  add_row("p95", [](const Evaluation& e) { return fixed(e.representation.p95, 3); });
  add_row("Hausd.", [](const Evaluation& e) { return fixed(e.representation.hausdorff, 2); });
  add_row("plain", [](const Evaluation& e) { return fixed(e.representation.plain_flips, 1); });
  add_row("conf.", [](const Evaluation& e) { return fixed(e.representation.confirmed_flips, 1); });
  add_row("opp.mean", [](const Evaluation& e) { return fixed(e.representation.opposing_mean, 1); });
  add_row("variance", [](const Evaluation& e) { return fixed(e.total_variance, 3); });
  add_row("truth",
          [](const Evaluation& e) { return e.truth ? fixed(e.truth->error.mean, 3) : std::string("-"); });
  add_row("truth95",
          [](const Evaluation& e) { return e.truth ? fixed(e.truth->error.p95, 3) : std::string("-"); });
  return table;
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
  for (const fs::path& model : models) evaluations.push_back(read_metrics(model));
  std::vector<NamedEvaluation> named;
  for (std::size_t i = 0; i < models.size(); ++i) named.push_back({folder_name(models[i]), &evaluations[i]});

  std::vector<ReportTable> tables = model_tables(named);
  tables.insert(tables.begin(), single_figures(named));
  const std::vector<Chart> charts = model_charts(named);

  ModelComparison comparison;
  for (const ReportTable& table : tables) comparison.text += table_text(table);
  comparison.json = as_json(named, tables).dump(2);
  ReportPage page{"Comparison of models",
                  "",
                  {{.title = "Curves", .charts = charts}, {.title = "Figures", .tables = tables}}};
  for (const NamedEvaluation& model : named)
    page.subtitle += (page.subtitle.empty() ? "" : ", ") + model.name;
  comparison.html = report_html(page);
  const std::vector<std::string> files{"generalization.svg",          "specificity.svg",
                                       "generalization_mean.svg",     "specificity_mean.svg",
                                       "ensemble_generalization.svg", "compactness.svg"};
  for (std::size_t i = 0; i < charts.size() && i < files.size(); ++i)
    comparison.charts.emplace_back(files[i], svg_chart(charts[i]));
  return comparison;
}

}  // namespace foramen
