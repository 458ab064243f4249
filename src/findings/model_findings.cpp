#include "findings/model_findings.hpp"

#include "findings/mark_findings.hpp"
#include "findings/model_report.hpp"
#include "findings/papers.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

std::string text_of(const ordered_json& value) {
  return value.is_null() ? "-" : value.is_string() ? value.get<std::string>() : value.dump();
}

int modes_of(const Evaluation& evaluation) {
  return evaluation.compactness.empty() ? 0 : evaluation.compactness.back().modes;
}

std::string flips_line(const RunRecord& run, const Evaluation& evaluation) {
  int map_flips = 0, plain = 0, confirmed = 0;
  for (const RunShape& shape : run.shapes)
    if (shape.used) map_flips += shape.used->flips_in_map.value_or(0);
  for (const ShapeRepresentation& r : evaluation.representation.shapes) {
    plain += r.plain_flips;
    confirmed += r.confirmed_flips;
  }
  const std::size_t triangles = evaluation.names.size() * static_cast<std::size_t>(run.landmark_triangles);
  return "flipped triangles: " + std::to_string(map_flips) + " in the maps; " + std::to_string(confirmed) +
         " confirmed and " + std::to_string(plain) + " plain of " + std::to_string(triangles) +
         " in the sampled meshes";
}

std::string self_intersections_line(const RunRecord& run, const Evaluation& evaluation) {
  int sampled = 0, input = 0;
  for (const ShapeRepresentation& r : evaluation.representation.shapes) {
    sampled += r.self_intersections;
    input += r.input_self_intersections;
  }
  std::string line =
      "self-intersecting pairs of triangles: " + std::to_string(sampled) + " in the sampled meshes, ";
  if (const int before = run.self_intersections_before_mending; before > 0)
    line += std::to_string(before) + " before they were mended, ";
  return line + std::to_string(input) + " in the inputs";
}

std::string representation_line(const Evaluation& evaluation) {
  const Representation& r = evaluation.representation;
  std::size_t worst = 0;
  for (std::size_t i = 0; i < r.shapes.size(); ++i)
    if (r.shapes[i].distance.hausdorff > r.shapes[worst].distance.hausdorff) worst = i;
  return "representation error: mean " + fixed(r.mean_surface.mean, 3) + " mm, p95 " + fixed(r.p95.mean, 3) +
         " mm, Hausdorff " + fixed(r.hausdorff.mean, 2) + " mm (worst " +
         fixed(r.shapes[worst].distance.hausdorff, 2) + " mm, " + evaluation.names[worst] + ")";
}

std::string refit_line(const RefitGeneralization& refit, std::size_t shapes) {
  const std::string left_out = refit.generalization.leave_out == LeaveOut::shape ? "shape" : "subject";
  std::string line = "refit, correspondence computed without the " + left_out + ": " +
                     std::to_string(refit.names.size()) + " of " + std::to_string(shapes) + " shapes entered";
  if (const auto* g = at_quoted_modes(refit.generalization.by_modes))
    line += ", generalization at " + std::to_string(g->modes) + " modes: Hausdorff " +
            fixed(g->hausdorff, 2) + " mm, mean surface " + fixed(g->mean_surface, 3) + " mm";
  return line;
}

}  // namespace

std::vector<std::string> summary_lines(const RunRecord& run, const Evaluation& evaluation) {
  const std::size_t used = evaluation.names.size();
  std::vector<std::string> lines;
  lines.push_back(std::to_string(used) + " of " + std::to_string(run.shapes.size()) +
                  " shapes used, reference " + run.reference + ", " + std::to_string(evaluation.landmarks) +
                  " landmarks (" + std::to_string(run.landmarks_inserted) + " inserted by refinement), " +
                  std::to_string(modes_of(evaluation)) + " modes");
  lines.push_back(flips_line(run, evaluation));
  lines.push_back(self_intersections_line(run, evaluation));
  lines.push_back(representation_line(evaluation));
  if (const auto* g = at_quoted_modes(evaluation.leave_one_out.by_modes))
    lines.push_back("generalization at " + std::to_string(g->modes) + " modes (leave one out): Hausdorff " +
                    fixed(g->hausdorff, 2) + " mm, mean surface " + fixed(g->mean_surface, 3) + " mm");
  for (const auto* refit : {&evaluation.refit, &evaluation.refit_by_subject})
    if (*refit) lines.push_back(refit_line(**refit, used));
  if (const auto* s = at_quoted_modes(evaluation.specificity.by_modes))
    lines.push_back("specificity at " + std::to_string(s->modes) + " modes: Hausdorff " +
                    fixed(s->hausdorff, 2) + " mm, mean surface " + fixed(s->mean_surface, 3) + " mm");
  lines.push_back(drawn_shapes_line(evaluation.drawn));
  lines.push_back("total variance: " + fixed(evaluation.total_variance, 2) +
                  " mm² a landmark (landmark weights: " + std::string(word_of(evaluation.options.weights)) +
                  ")");
  if (evaluation.truth)
    lines.push_back("truth error: mean " + fixed(evaluation.truth->error.mean, 2) + " mm, p95 " +
                    fixed(evaluation.truth->error.p95, 2) + " mm, largest " +
                    fixed(evaluation.truth->error.max, 2) + " mm (floor: mean " +
                    fixed(evaluation.truth->floor.mean, 3) + " mm)");
  for (std::string& line : mark_lines(evaluation)) lines.push_back(std::move(line));
  return lines;
}

ReportTable shapes_table(const RunRecord& run, const Evaluation& evaluation) {
  ReportTable table{
      "Representation and flips",
      "Distances of the corresponding mesh to the input surface. Flipped triangles: of the map "
      "(exact), and of the sampled mesh, plain and confirmed. Self-intersecting pairs of triangles: "
      "of the sampled mesh, and of the input. Distortion: area-weighted mean, 4 at best.",
      {"shape", "status", "mean, mm", "p95, mm", "Hausdorff, mm", "flips in map", "plain flips",
       "confirmed flips", "self-int.", "of input", "distortion"},
      {}};
  std::size_t i = 0;
  for (const RunShape& shape : run.shapes) {
    if (!shape.used) continue;
    const ShapeRepresentation& r = evaluation.representation.shapes.at(i++);
    table.rows.push_back({shape.name, std::string(word_of(shape.status)), fixed(r.distance.mean, 3),
                          fixed(r.distance.p95, 3), fixed(r.distance.hausdorff, 2),
                          shape.used->flips_in_map ? std::to_string(*shape.used->flips_in_map) : "-",
                          std::to_string(r.plain_flips), std::to_string(r.confirmed_flips),
                          std::to_string(r.self_intersections), std::to_string(r.input_self_intersections),
                          shape.used->map ? fixed(shape.used->map->distortion, 2) : "-"});
  }
  return table;
}

ReportTable left_out_table(const RunRecord& run) {
  ReportTable table{"Left out", "", {"shape", "reason"}, {}};
  for (const RunShape& shape : run.shapes)
    if (!shape.used) table.rows.push_back({shape.name, shape.reason});
  return table;
}

ReportTable repairs_table(const RunRecord& run) {
  ReportTable table{
      "Repaired",
      "These files could not be used as they are. Their distances are measured to the repaired surface, "
      "which differs from the file's at the places named.",
      {"shape", "changes"},
      {}};
  for (const RunShape& shape : run.shapes)
    if (shape.used && shape.used->repair) table.rows.push_back({shape.name, shape.reason});
  return table;
}

ReportTable refit_failures_table(const Evaluation& evaluation) {
  ReportTable table{
      "Failed in a refit",
      "A shape that is itself left out of the refit has no figure; another was not part of that "
      "refit's model.",
      {"shape", "refit without", "reason"},
      {}};
  for (const auto* refit : {&evaluation.refit, &evaluation.refit_by_subject})
    if (*refit)
      for (const RefitGeneralization::Failure& f : (*refit)->failures)
        table.rows.push_back({f.shape, f.without, f.reason});
  return table;
}

ReportTable options_table(const RunRecord& run) {
  ReportTable table{"Options", "", {"option", "value"}, {}};
  for (const auto& [key, value] : run.options.by_name().items()) {
    if (!value.is_object())
      table.rows.push_back({key, text_of(value)});
    else
      for (const auto& [part, of_part] : value.items())
        table.rows.push_back({key + ": " + part, text_of(of_part)});
  }
  return table;
}

ReportTable inputs_table(const RunRecord& run) {
  ReportTable table{"Inputs", "", {"file", "sha256"}, {}};
  for (const RunInput& input : run.inputs) table.rows.push_back({input.file, input.sha256});
  return table;
}

ReportTable papers_table(const RunRecord& run) {
  ReportTable table{"Papers", "", {"paper", "used for"}, {}};
  for (const Paper& paper : papers_used(run.options))
    table.rows.push_back({std::string(paper.citation), std::string(paper.used_for)});
  return table;
}

std::string made_by(const RunRecord& run) { return "foramen " + run.version + ": " + run.command; }

}  // namespace foramen
