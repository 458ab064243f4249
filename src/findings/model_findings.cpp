#include "findings/model_findings.hpp"

#include "findings/model_report.hpp"
#include "findings/papers.hpp"
#include "modelfiles/model_record.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

std::string text_of(const ordered_json& value) {
  return value.is_null() ? "-" : value.is_string() ? value.get<std::string>() : value.dump();
}

int modes_of(const Evaluation& evaluation) {
  return evaluation.compactness.empty() ? 0 : evaluation.compactness.back().modes;
}

std::string flips_line(const ordered_json& run, const Evaluation& evaluation) {
  int map_flips = 0, plain = 0, confirmed = 0;
  for (const ordered_json& shape : run.at("shapes"))
    if (is_used(shape) && !shape.at("flips_in_map").is_null())
      map_flips += shape.at("flips_in_map").get<int>();
  for (const ShapeRepresentation& r : evaluation.representation.shapes) {
    plain += r.plain_flips;
    confirmed += r.confirmed_flips;
  }
  const std::size_t triangles = evaluation.names.size() * run.at("landmark_triangles").get<std::size_t>();
  return "flipped triangles: " + std::to_string(map_flips) + " in the maps; " + std::to_string(confirmed) +
         " confirmed and " + std::to_string(plain) + " plain of " + std::to_string(triangles) +
         " in the sampled meshes";
}

std::string self_intersections_line(const ordered_json& run, const Evaluation& evaluation) {
  int sampled = 0, input = 0;
  for (const ShapeRepresentation& r : evaluation.representation.shapes) {
    sampled += r.self_intersections;
    input += r.input_self_intersections;
  }
  std::string line =
      "self-intersecting pairs of triangles: " + std::to_string(sampled) + " in the sampled meshes, ";
  if (const int before = run.value("self_intersections_before_mending", 0); before > 0)
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

std::vector<std::string> summary_lines(const ordered_json& run, const Evaluation& evaluation) {
  const std::size_t used = evaluation.names.size();
  std::vector<std::string> lines;
  lines.push_back(std::to_string(used) + " of " + std::to_string(run.at("shapes").size()) +
                  " shapes used, reference " + run.at("reference").get<std::string>() + ", " +
                  std::to_string(evaluation.landmarks) + " landmarks (" +
                  run.at("landmarks_inserted").dump() + " inserted by refinement), " +
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
  return lines;
}

ReportTable shapes_table(const ordered_json& run, const Evaluation& evaluation) {
  ReportTable table{
      "Representation and flips",
      "Distances of the corresponding mesh to the input surface. Flipped triangles: of the map "
      "(exact), and of the sampled mesh, plain and confirmed. Self-intersecting pairs of triangles: "
      "of the sampled mesh, and of the input. Distortion: area-weighted mean, 4 at best.",
      {"shape", "status", "mean, mm", "p95, mm", "Hausdorff, mm", "flips in map", "plain flips",
       "confirmed flips", "self-int.", "of input", "distortion"},
      {}};
  std::size_t i = 0;
  for (const ordered_json& shape : run.at("shapes")) {
    if (!is_used(shape)) continue;
    const ShapeRepresentation& r = evaluation.representation.shapes.at(i++);
    table.rows.push_back(
        {shape.at("name").get<std::string>(), shape.at("status").get<std::string>(),
         fixed(r.distance.mean, 3), fixed(r.distance.p95, 3), fixed(r.distance.hausdorff, 2),
         text_of(shape.at("flips_in_map")), std::to_string(r.plain_flips), std::to_string(r.confirmed_flips),
         std::to_string(r.self_intersections), std::to_string(r.input_self_intersections),
         shape.contains("distortion") ? fixed(shape.at("distortion").get<double>(), 2) : "-"});
  }
  return table;
}

ReportTable left_out_table(const ordered_json& run) {
  ReportTable table{"Left out", "", {"shape", "reason"}, {}};
  for (const ordered_json& shape : run.at("shapes"))
    if (!is_used(shape))
      table.rows.push_back({shape.at("name").get<std::string>(), shape.at("reason").get<std::string>()});
  return table;
}

ReportTable repairs_table(const ordered_json& run) {
  ReportTable table{
      "Repaired",
      "These files could not be used as they are. Their distances are measured to the repaired surface, "
      "which differs from the file's at the places named.",
      {"shape", "changes"},
      {}};
  for (const ordered_json& shape : run.at("shapes"))
    if (shape.contains("repair"))
      table.rows.push_back({shape.at("name").get<std::string>(), shape.at("reason").get<std::string>()});
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

ReportTable options_table(const ordered_json& run) {
  ReportTable table{"Options", "", {"option", "value"}, {}};
  for (const auto& [key, value] : run.at("options").items()) {
    if (!value.is_object())
      table.rows.push_back({key, text_of(value)});
    else
      for (const auto& [part, of_part] : value.items())
        table.rows.push_back({key + ": " + part, text_of(of_part)});
  }
  return table;
}

ReportTable inputs_table(const ordered_json& run) {
  ReportTable table{"Inputs", "", {"file", "sha256"}, {}};
  for (const ordered_json& input : run.at("inputs"))
    table.rows.push_back({input.at("file").get<std::string>(), input.at("sha256").get<std::string>()});
  return table;
}

ReportTable papers_table(const ordered_json& run) {
  ReportTable table{"Papers", "", {"paper", "used for"}, {}};
  for (const Paper& paper : papers_used(run.at("options")))
    table.rows.push_back({std::string(paper.citation), std::string(paper.used_for)});
  return table;
}

std::string made_by(const ordered_json& run) {
  return "foramen " + run.at("version").get<std::string>() + ": " + run.at("command").get<std::string>();
}

}  // namespace foramen
