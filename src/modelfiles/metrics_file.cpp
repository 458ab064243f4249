#include "modelfiles/metrics_file.hpp"

#include <fstream>
#include <iterator>

#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "io/atomic_file.hpp"
#include "modelfiles/marks_json.hpp"
#include "modelfiles/metrics_rows.hpp"
#include "modelfiles/options_json.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

constexpr int format_version = 1;

ordered_json to_json(const Estimate& e) { return {{"mean", e.mean}, {"standard_error", e.standard_error}}; }

Estimate estimate_from(const ordered_json& j) { return {j.at("mean"), j.at("standard_error")}; }

ordered_json to_json(const std::vector<ErrorsAtModes>& by_modes) {
  ordered_json out = ordered_json::array();
  for (const ErrorsAtModes& e : by_modes)
    out.push_back({{"modes", e.modes},
                   {"hausdorff_mm", to_json(e.hausdorff)},
                   {"mean_surface_mm", to_json(e.mean_surface)},
                   {"landmark_rms_mm", to_json(e.landmark_rms)}});
  return out;
}

std::vector<ErrorsAtModes> errors_from(const ordered_json& j) {
  std::vector<ErrorsAtModes> out;
  for (const ordered_json& e : j)
    out.push_back({e.at("modes"),
                   {},
                   estimate_from(e.at("hausdorff_mm")),
                   estimate_from(e.at("mean_surface_mm")),
                   estimate_from(e.at("landmark_rms_mm"))});
  return out;
}

ordered_json to_json(const ErrorSummary& e) { return {{"mean", e.mean}, {"p95", e.p95}, {"max", e.max}}; }

ErrorSummary summary_from(const ordered_json& j) { return {j.at("mean"), j.at("p95"), j.at("max")}; }

EvaluationOptions options_from(const ordered_json& j) {
  EvaluationOptions options;
  set_options(options, j);
  return options;
}

const char* weights_definition(LandmarkWeights weights) {
  return weights == LandmarkWeights::equal
             ? "in alignment, PCA and landmark distances every landmark counts alike"
             : "in alignment, PCA and landmark distances a landmark counts by the area around it (a third of "
               "that of its "
               "triangles) on the mean of the unweighted alignment, divided by the average of these areas";
}

ordered_json compactness_json(const Evaluation& e) {
  ordered_json by_modes = ordered_json::array();
  for (const CompactnessAtModes& c : e.compactness)
    by_modes.push_back(
        {{"modes", c.modes}, {"variance_mm2", c.variance_per_landmark}, {"fraction", c.fraction}});
  return {
      {"definition", "sum of the first M variances per landmark (divisor n - 1), and its share of the total"},
      {"unit", "mm^2 per landmark"},
      {"by_modes", by_modes}};
}

ordered_json generalization_json(const Generalization& g, const char* left_out) {
  return {{"definition",
           std::string("leave one ") + left_out +
               " out: alignment and PCA redone without it, its reconstruction on M modes against the "
               "original input surface; mean over shapes, standard error s / sqrt(n)"},
          {"unit", "mm"},
          {"groups", g.groups},
          {"by_modes", to_json(g.by_modes)}};
}

ordered_json refit_json(const RefitGeneralization& refit, const char* left_out) {
  ordered_json failures = ordered_json::array();
  for (const RefitGeneralization::Failure& f : refit.failures)
    failures.push_back({{"name", f.shape}, {"without", f.without}, {"reason", f.reason}});
  return {{"definition",
           std::string("leave one ") + left_out +
               " out of the whole build: correspondence, alignment and PCA redone without it, the shape then "
               "registered to that model and its reconstruction on M modes compared with the original input "
               "surface; mean over the shapes that entered, standard error s / sqrt(n)"},
          {"unit", "mm"},
          {"groups", refit.generalization.groups},
          {"names", refit.names},
          {"failures", failures},
          {"by_modes", to_json(refit.generalization.by_modes)}};
}

RefitGeneralization refit_from(const ordered_json& j, LeaveOut leave_out) {
  RefitGeneralization refit{{leave_out, j.at("groups"), errors_from(j.at("by_modes"))},
                            j.at("names").get<std::vector<std::string>>(),
                            {}};
  for (const ordered_json& f : j.at("failures"))
    refit.failures.push_back({f.at("name"), f.at("without"), f.at("reason")});
  return refit;
}

ordered_json specificity_json(const Evaluation& e) {
  return {{"definition",
           "random shapes b_m ~ N(0, variance_m), m <= M; distance to the closest training input surface; "
           "mean over random shapes"},
          {"unit", "mm"},
          {"by_modes", to_json(e.specificity.by_modes)}};
}

ordered_json ensemble_json(const Evaluation& e) {
  ordered_json by_modes = ordered_json::array();
  for (const EnsembleAtModes& m : e.ensemble)
    by_modes.push_back({{"modes", m.modes},
                        {"generalization_mm", to_json(m.generalization)},
                        {"specificity_mm", to_json(m.specificity)}});
  return {{"definition",
           "the paper's ensemble form on the same random shapes: generalization, in-sample: mean over "
           "training shapes of the smallest "
           "Hausdorff distance to a random shape; specificity: mean over random shapes of that to a training "
           "shape"},
          {"unit", "mm"},
          {"by_modes", by_modes}};
}

ordered_json representation_json(const Evaluation& e) {
  const Representation& r = e.representation;
  ordered_json shapes = ordered_json::array();
  for (std::size_t i = 0; i < r.shapes.size(); ++i) {
    const ShapeRepresentation& s = r.shapes[i];
    shapes.push_back({{"name", e.names[i]},
                      {"mean_mm", s.distance.mean},
                      {"p95_mm", s.distance.p95},
                      {"hausdorff_mm", s.distance.hausdorff},
                      {"plain_flips", s.plain_flips},
                      {"confirmed_flips", s.confirmed_flips},
                      {"degenerate", s.degenerate},
                      {"opposing_mean", s.opposing_mean},
                      {"self_intersections", s.self_intersections},
                      {"input_self_intersections", s.input_self_intersections}});
  }
  return {
      {"definition",
       "surface distance of each corresponding mesh to its original input, and flipped triangles of it; "
       "self-intersections: pairs of its triangles, and of the input's, with a point in common beyond what "
       "they share as neighbours"},
      {"unit", "mm; triangles; pairs of triangles"},
      {"mean_mm", to_json(r.mean_surface)},
      {"p95_mm", to_json(r.p95)},
      {"hausdorff_mm", to_json(r.hausdorff)},
      {"plain_flips", to_json(r.plain_flips)},
      {"confirmed_flips", to_json(r.confirmed_flips)},
      {"opposing_mean", to_json(r.opposing_mean)},
      {"self_intersections", to_json(r.self_intersections)},
      {"input_self_intersections", to_json(r.input_self_intersections)},
      {"shapes", shapes}};
}

Representation representation_from(const ordered_json& j) {
  Representation r;
  for (const ordered_json& s : j.at("shapes"))
    r.shapes.push_back({{s.at("mean_mm"), s.at("p95_mm"), s.at("hausdorff_mm")},
                        s.at("plain_flips"),
                        s.at("confirmed_flips"),
                        s.at("degenerate"),
                        s.at("opposing_mean"),
                        s.at("self_intersections"),
                        s.at("input_self_intersections"),
                        {}});
  r.mean_surface = estimate_from(j.at("mean_mm"));
  r.p95 = estimate_from(j.at("p95_mm"));
  r.hausdorff = estimate_from(j.at("hausdorff_mm"));
  r.plain_flips = estimate_from(j.at("plain_flips"));
  r.confirmed_flips = estimate_from(j.at("confirmed_flips"));
  r.opposing_mean = estimate_from(j.at("opposing_mean"));
  r.self_intersections = estimate_from(j.at("self_intersections"));
  r.input_self_intersections = estimate_from(j.at("input_self_intersections"));
  return r;
}

ordered_json drawn_json(const DrawnShapes& d) {
  return {{"definition",
           "random shapes over all modes, every score drawn anew until it is within the largest: the share "
           "with a self-intersection, the share with a triangle folded over against its surroundings, and "
           "the share with a triangle opposing the same triangle of the mean"},
          {"unit", "share of the random shapes"},
          {"largest_score_sd", largest_drawn_sd},
          {"self_intersecting", to_json(d.self_intersecting)},
          {"folded", to_json(d.folded)},
          {"opposing_mean", to_json(d.opposing_mean)}};
}

DrawnShapes drawn_from(const ordered_json& j) {
  return {{},
          estimate_from(j.at("self_intersecting")),
          estimate_from(j.at("folded")),
          estimate_from(j.at("opposing_mean"))};
}

ordered_json truth_json(const TruthError& t) {
  return {{"definition",
           "landmark i of shape A, carried to shape B by the true map, to landmark i of B; over landmarks "
           "and ordered pairs"},
          {"unit", "mm"},
          {"error", to_json(t.error)},
          {"floor", to_json(t.floor)},
          {"mean_from_shape", t.mean_from_shape}};
}

Evaluation evaluation_from(const ordered_json& j) {
  Evaluation e;
  e.options = options_from(j.at("options"));
  e.names = j.at("names").get<std::vector<std::string>>();
  e.subjects = j.at("subjects").get<std::vector<std::string>>();
  e.landmarks = j.at("landmarks");
  e.total_variance = j.at("total_variance_mm2");
  for (const ordered_json& c : j.at("compactness").at("by_modes"))
    e.compactness.push_back({c.at("modes"), c.at("variance_mm2"), c.at("fraction")});
  const ordered_json& one = j.at("generalization");
  e.leave_one_out = {LeaveOut::shape, one.at("groups"), errors_from(one.at("by_modes"))};
  if (const ordered_json& subject = j.at("generalization_by_subject"); !subject.is_null())
    e.leave_subject_out =
        Generalization{LeaveOut::subject, subject.at("groups"), errors_from(subject.at("by_modes"))};
  if (j.contains("refit")) e.refit = refit_from(j.at("refit"), LeaveOut::shape);
  if (j.contains("refit_by_subject"))
    e.refit_by_subject = refit_from(j.at("refit_by_subject"), LeaveOut::subject);
  e.specificity.by_modes = errors_from(j.at("specificity").at("by_modes"));
  for (const ordered_json& m : j.at("ensemble").at("by_modes"))
    e.ensemble.push_back(
        {m.at("modes"), estimate_from(m.at("generalization_mm")), estimate_from(m.at("specificity_mm"))});
  e.drawn = drawn_from(j.at("drawn_shapes"));
  e.representation = representation_from(j.at("representation"));
  if (const ordered_json& t = j.at("truth"); !t.is_null())
    e.truth = TruthError{summary_from(t.at("error")), summary_from(t.at("floor")),
                         t.at("mean_from_shape").get<std::vector<double>>()};
  if (j.contains("marks")) e.marks = marks_from(j.at("marks"), e.names);
  if (j.contains("regions")) e.regions = regions_from(j.at("regions"), e.names);
  return e;
}

}  // namespace

std::string metrics_json(const Evaluation& e) {
  ordered_json out = {
      {"format", format_version},
      {"names", e.names},
      {"subjects", e.subjects},
      {"landmarks", e.landmarks},
      {"total_variance_mm2", e.total_variance},
      {"options", described_json(e.options)},
      {"landmark_weights_definition", weights_definition(e.options.weights)},
      {"representation", representation_json(e)},
      {"compactness", compactness_json(e)},
      {"generalization", generalization_json(e.leave_one_out, "shape")},
      {"generalization_by_subject",
       e.leave_subject_out ? generalization_json(*e.leave_subject_out, "subject") : ordered_json()},
      {"specificity", specificity_json(e)},
      {"ensemble", ensemble_json(e)},
      {"drawn_shapes", drawn_json(e.drawn)},
      {"truth", e.truth ? truth_json(*e.truth) : ordered_json()}};
  if (e.refit) out["refit"] = refit_json(*e.refit, "shape");
  if (e.refit_by_subject) out["refit_by_subject"] = refit_json(*e.refit_by_subject, "subject");
  if (e.marks) out["marks"] = marks_json(*e.marks, e.names);
  if (e.regions) out["regions"] = regions_json(*e.regions, e.names);
  return out.dump(2);
}

Evaluation parse_metrics(std::string_view json, const std::string& name) {
  try {
    return evaluation_from(ordered_json::parse(json));
  } catch (const nlohmann::json::exception& e) {
    throw IoError(name + ": is not a metrics file of this version (" + e.what() +
                      "); an evaluation of the model writes it anew",
                  {{RemedyKind::evaluate_model}});
  }
}

void write_metrics(const std::filesystem::path& folder, const Evaluation& evaluation) {
  write_file(folder / "metrics.json", metrics_json(evaluation) + "\n");
  write_metrics_rows(folder / "metrics.csv", evaluation);
}

Evaluation read_metrics(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "metrics.json";
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw IoError(
        file.string() + ": cannot be read; the build of a model writes it, and so does an evaluation",
        {{RemedyKind::build_model}, {RemedyKind::evaluate_model}});
  return parse_metrics(std::string(std::istreambuf_iterator<char>(in), {}), file.string());
}

Evaluation read_metrics_of_shapes(const std::filesystem::path& folder) {
  Evaluation evaluation = read_metrics(folder);
  read_shape_items(folder / "metrics.csv", evaluation);
  return evaluation;
}

}  // namespace foramen
