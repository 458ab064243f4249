#include "pipeline/run_json.hpp"

#include <sys/resource.h>

#include <algorithm>

#include "foramen/pipeline/repair_record.hpp"
#include "foramen/pipeline/version.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

ordered_json matrix_json(const Eigen::Matrix2i& m) { return {{m(0, 0), m(0, 1)}, {m(1, 0), m(1, 1)}}; }

ordered_json certificate_json(const RegisteredShape& shape, const ReferenceLoops& reference) {
  const MapCertificate& c = shape.shape_map.certificate;
  return {{"mesh", "input"},
          {"triangles", c.triangles},
          {"flipped", c.flipped},
          {"smallest_area_ratio", c.smallest_area_ratio},
          {"largest_area_ratio", c.largest_area_ratio},
          {"degree", c.degree},
          {"homology_matrix", matrix_json(shape.homology)},
          {"seifert_matrix", matrix_json(shape.seifert)},
          {"reference_seifert_matrix", matrix_json(reference.seifert)},
          {"map_agreement", {shape.agreement.x(), shape.agreement.y()}}};
}

ordered_json shape_json(const ModelBuild& build, std::size_t i, const Evaluation& evaluation, bool torus) {
  const ShapeOutcome& shape = build.shapes[i];
  const RegisteredShape& registration = shape.registration;
  const bool is_reference = static_cast<int>(i) == build.reference;
  ordered_json out = {{"name", shape.input.stem},
                      {"status", is_reference ? "reference" : "used"},
                      {"reason", shape.input.was_inward ? "wound inward; reversed" : ""},
                      {"seconds", shape.seconds},
                      {"alignment_residual_mm", registration.alignment.residual}};
  if (shape.input.repair) {
    out["reason"] = "repaired: " + summary(*shape.input.repair);
    out["repair"] = repair_json(*shape.input.repair);
  }
  if (torus || is_reference) {
    out["iterations"] = registration.shape_map.iterations;
    out["energy_initial"] = registration.shape_map.initial_energy;
    out["energy_final"] = registration.shape_map.final_energy;
    out["distortion"] = registration.shape_map.distortion;
    out["certificate"] = certificate_json(registration, build.reference_map.loops);
  } else {
    out["landmarks_without_compatible_point"] = shape.unmatched;
  }
  const ShapeRepresentation& r = evaluation.representation.shapes[i];
  out["flips_in_map"] =
      torus || is_reference ? ordered_json(registration.shape_map.certificate.flipped) : ordered_json();
  out["flips_sampled_plain"] = r.plain_flips;
  out["flips_sampled_confirmed"] = r.confirmed_flips;
  out["triangles_opposing_mean"] = r.opposing_mean;
  out["self_intersections"] = r.self_intersections;
  out["input_self_intersections"] = r.input_self_intersections;
  return out;
}

ordered_json inputs_json(const ModelBuild& build) {
  ordered_json inputs = ordered_json::array();
  for (const ShapeOutcome& shape : build.shapes) {
    inputs.push_back({{"file", shape.input.file_name},
                      {"sha256", shape.input.sha256},
                      {"vertices", shape.input.mesh.vertex_count()},
                      {"triangles", shape.input.mesh.face_count()}});
    if (!shape.input.label) continue;
    inputs.back()["label"] = *shape.input.label;
    inputs.back()["extraction"] = extraction_json(shape.input.extraction);
  }
  for (const LeftOut& shape : build.left_out) {
    inputs.push_back({{"file", shape.file_name}, {"sha256", shape.sha256}});
    if (shape.label) inputs.back()["label"] = *shape.label;
  }
  return inputs;
}

ordered_json deform_json(const DeformTemplateOptions& o) {
  return {{"noise_mm", o.noise_mm},
          {"iterations", o.iterations},
          {"samples", o.match.samples},
          {"normal_weight_mm", o.match.normal_weight},
          {"tangential_share", o.match.tangential_share},
          {"independent_area_mm2", o.match.independent_area_mm2},
          {"rejection_medians", o.match.rejection},
          {"least_median_mm", o.match.least_median_mm}};
}

ordered_json scales_json(const SmoothDisplacementOptions& o) {
  ordered_json scales = ordered_json::array();
  for (const DisplacementScale& s : o.scales)
    scales.push_back({{"length_mm", s.length_mm}, {"amplitude_mm", s.amplitude_mm}});
  return scales;
}

// How shapes are registered with each other.
ordered_json options_json(const RegisterGroupOptions& g) {
  return {{"lambda_mm2", g.lambda},
          {"initial_map", g.initial_map == InitialMap::torus ? "torus" : "rectangle"},
          {"edge_cost", g.edge_cost == EdgeCost::paper ? "paper" : "length_weighted"},
          {"distortion", g.distortion == DistortionMeasure::on_template ? "template" : "plane"},
          {"bending", g.bending == Bending::cohort   ? "cohort"
                      : g.bending == Bending::smooth ? "smooth"
                                                     : "rigid"},
          {"rounds", g.round_limit},
          {"still_mm", g.still_mm},
          {"metric_updates", g.metric_updates},
          {"description_rounds", g.description_rounds},
          {"description_cut_mm2", g.description.cut_mm2},
          {"template_vertices", g.mean.vertices},
          {"template_grid_points", g.mean.grid_points},
          {"displacement_scales", scales_json(g.displacements)},
          {"displacement_shift_mm", g.displacements.shift_mm},
          {"displacement_linear_mm", g.displacements.linear_mm},
          {"displacement_left_out_mm", g.displacements.left_out_mm},
          {"displacement_functions_limit", g.displacements.most_functions},
          {"cohort_noise_mm", g.cohort.noise_mm},
          {"cohort_independent_area_mm2", g.cohort.independent_area_mm2},
          {"cohort_least_share", g.cohort.least_share},
          {"bending_first", deform_json(g.first)},
          {"bending_again", deform_json(g.again)},
          {"targets_reach_mm", g.targets.reach_mm},
          {"targets_min_normal_cosine", g.targets.min_normal_cosine},
          {"working_vertices", g.working_vertices},
          {"relative_tolerance", g.relative_tolerance},
          {"iteration_limit", g.iteration_limit}};
}

// The same of each shape with the reference, and of the reference itself.
ordered_json options_json(const RegisterOptions& r) {
  return {{"lambda", r.lambda},
          {"weighting", r.weighting == Weighting::area ? "area" : "each"},
          {"initial_map", r.initial_map == InitialMap::torus ? "torus" : "rectangle"},
          {"optimiser", r.optimiser == Optimiser::newton ? "newton" : "polak-ribiere"},
          {"edge_cost", r.edge_cost == EdgeCost::paper ? "paper" : "length_weighted"},
          {"neighbours", r.neighbours.count},
          {"neighbour_search", r.neighbours.search == NeighbourSearch::points ? "points" : "oriented_points"},
          {"neighbour_weights", r.neighbours.weights == NeighbourWeights::absolute ? "absolute" : "relative"},
          {"working_vertices", r.working_vertices},
          {"relative_tolerance", r.relative_tolerance},
          {"iteration_limit", r.iteration_limit}};
}

// Null: the method has none.
ordered_json objective_json(const BuildOptions& options) {
  if (options.method == Method::icp) return nullptr;
  if (options.objective == Objective::neighbours) return "neighbours";
  return options.group.description_rounds > 0 ? "description" : "surface";
}

ordered_json lambda_json(const BuildOptions& options) {
  if (options.method == Method::icp) return nullptr;
  return registered_together(options) ? options.group.lambda : options.registration.lambda;
}

}  // namespace

ordered_json extraction_json(const ExtractionReport& r) {
  return {{"genus", r.genus},
          {"edge_contacts", r.contact == EdgeContact::joined ? "joined" : "apart"},
          {"components", r.components},
          {"voxels", r.voxels},
          {"voxels_left_out", r.lost_voxels},
          {"voxels_filled", r.filled_voxels},
          {"cut_at", r.cut_at},
          {"voxel_volume_mm3", r.voxel_volume},
          {"volume_mm3", r.volume},
          {"deviation_voxels", {{"p95", r.deviation.p95}, {"largest", r.deviation.hausdorff}}},
          {"deviation_mm", {{"p95", r.deviation_mm.p95}, {"largest", r.deviation_mm.hausdorff}}},
          {"bound_voxels", r.bound},
          {"vertices_restrained", r.restrained}};
}

ordered_json label_options_json(const LabelRequest& request) {
  return {{"labels", request.labels ? ordered_json(request.labels->text()) : ordered_json()},
          {"keep_cut", request.surface.keep_cut},
          {"smoothing_rounds", request.surface.smoothing_rounds},
          {"bound_voxels", request.surface.bound_voxels}};
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

ordered_json options_json(const BuildOptions& options) {
  ordered_json out = {
      {"method", options.method == Method::torus ? "torus" : "icp"},
      {"objective", objective_json(options)},
      {"lambda", lambda_json(options)},
      {"reference", options.reference},
      {"landmarks", options.landmarks},
      {"target_error_mm", options.target_error_mm ? ordered_json(*options.target_error_mm) : ordered_json()},
      {"scale", options.scale == ScaleMode::keep ? "keep" : "remove"},
      {"landmark_weights", name(options.weights)},
      {"seed", options.seed}};
  if (registered_together(options)) out["group"] = options_json(options.group);
  out["registration"] = options_json(options.registration);
  out["resampling"] = {{"grid_points", options.grid_points},
                       {"density_contrast", options.remeshing.contrast},
                       {"density_floor", options.remeshing.density_floor},
                       {"density_smoothing_rounds", options.remeshing.smoothing_rounds},
                       {"relaxation_rounds", options.remeshing.relaxation_rounds},
                       {"curvature_radius", options.remeshing.curvature_radius},
                       {"density_updates", options.density_updates},
                       {"accepted_error_mm", options.errors.accepted_mm},
                       {"error_exponent", options.errors.exponent},
                       {"error_spread_rings", options.errors.spread_rings}};
  return out;
}

ordered_json run_json(const BuildRequest& request, const ModelBuild& build, const Evaluation& evaluation,
                      const RunFigures& figures) {
  const bool torus = request.build.method == Method::torus;
  ordered_json shapes = ordered_json::array();
  for (std::size_t i = 0; i < build.shapes.size(); ++i)
    shapes.push_back(shape_json(build, i, evaluation, torus));
  for (const LeftOut& shape : build.left_out)
    shapes.push_back({{"name", shape.stem}, {"status", "left out"}, {"reason", shape.reason}});
  ordered_json options = options_json(request.build);
  const bool from_labels =
      std::any_of(build.shapes.begin(), build.shapes.end(),
                  [](const ShapeOutcome& shape) { return shape.input.label.has_value(); });
  if (from_labels) options["label_maps"] = label_options_json(request.labels.value_or(LabelRequest{}));
  ordered_json stages = ordered_json::object();
  for (const auto& [name, time] : build.stage_seconds) stages[name] = time;
  stages["evaluate"] = evaluation.seconds.representation + evaluation.seconds.generalization +
                       evaluation.seconds.specificity + evaluation.seconds.drawn + evaluation.seconds.truth;
  if (evaluation.refit) stages["refit"] = evaluation.seconds.refit;
  return {{"version", version()},
          {"command", request.canonical_command},
          {"options", options},
          {"seed", request.build.seed},
          {"inputs", inputs_json(build)},
          {"reference", build.shapes[static_cast<std::size_t>(build.reference)].input.stem},
          {"template_motion_mm", build.template_motion_mm},
          {"unexplained_shares", build.unexplained_shares},
          {"description_lengths", build.description_lengths},
          {"landmarks", build.landmarks.turns.size()},
          {"landmarks_inserted", build.inserted_landmarks},
          {"self_intersections_before_mending", build.initial_self_intersections},
          {"self_intersections_not_mended", build.remaining_self_intersections},
          {"landmark_triangles", build.landmarks.triangles.size()},
          {"shapes", shapes},
          {"seconds", figures.seconds},
          {"seconds_by_stage", stages},
          {"threads", figures.threads},
          {"stages_taken_up", figures.stages_taken_up},
          {"peak_memory_mb", peak_memory_mb()}};
}

}  // namespace foramen
