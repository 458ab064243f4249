#include "modelfiles/run_json.hpp"

#include <sys/resource.h>

#include <algorithm>

#include "foramen/correspond/registration_frame.hpp"
#include "modelfiles/options_json.hpp"
#include "modelfiles/repair_record.hpp"
#include "modelfiles/version.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

ordered_json matrix_json(const Eigen::Matrix2i& m) { return {{m(0, 0), m(0, 1)}, {m(1, 0), m(1, 1)}}; }

ordered_json certificate_json(const ShapeRegistration& shape, const ReferenceLoops& reference) {
  const MapCertificate& c = shape.certificate;
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

ordered_json shape_json(const BuildRecord& record, std::size_t i, const Evaluation& evaluation) {
  const InputShape& input = record.inputs[i];
  const CohortRegistration& cohort = record.built.registration;
  const ShapeRegistration& shape = cohort.shapes[i];
  ordered_json out = {{"name", input.stem},
                      {"status", static_cast<int>(i) == cohort.reference ? "reference" : "used"},
                      {"reason", input.was_inward ? "wound inward; reversed" : ""},
                      {"seconds", shape.seconds},
                      {"alignment_residual_mm", shape.alignment.residual}};
  if (input.repair) {
    out["reason"] = "repaired: " + summary(*input.repair);
    out["repair"] = repair_json(*input.repair);
  }
  if (shape.mapped) {
    out["iterations"] = shape.iterations;
    out["energy_initial"] = shape.initial_energy;
    out["energy_final"] = shape.final_energy;
    out["distortion"] = shape.distortion;
    out["certificate"] = certificate_json(shape, cohort.frame.reference.loops);
  } else {
    out["landmarks_without_compatible_point"] = record.built.landmarks.without_compatible[i];
  }
  const ShapeRepresentation& r = evaluation.representation.shapes[i];
  out["flips_in_map"] = shape.mapped ? ordered_json(shape.certificate.flipped) : ordered_json();
  out["flips_sampled_plain"] = r.plain_flips;
  out["flips_sampled_confirmed"] = r.confirmed_flips;
  out["triangles_opposing_mean"] = r.opposing_mean;
  out["self_intersections"] = r.self_intersections;
  out["input_self_intersections"] = r.input_self_intersections;
  return out;
}

ordered_json inputs_json(const BuildRecord& record) {
  ordered_json inputs = ordered_json::array();
  for (const InputShape& input : record.inputs) {
    inputs.push_back({{"file", input.file_name},
                      {"sha256", input.sha256},
                      {"vertices", input.mesh.vertex_count()},
                      {"triangles", input.mesh.face_count()}});
    if (!input.label) continue;
    inputs.back()["label"] = *input.label;
    inputs.back()["extraction"] = extraction_json(input.extraction);
  }
  for (const LeftOut& shape : record.left_out) {
    inputs.push_back({{"file", shape.file_name}, {"sha256", shape.sha256}});
    if (shape.label) inputs.back()["label"] = *shape.label;
  }
  return inputs;
}

// Null: the method has none.
ordered_json objective_json(const CorrespondOptions& options) {
  if (options.method == Method::icp) return nullptr;
  if (options.objective == Objective::surface && options.group.description_rounds > 0) return "description";
  return word_of(options.objective);
}

ordered_json lambda_json(const CorrespondOptions& options) {
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
  ordered_json out = {{"labels", request.labels ? ordered_json(request.labels->text()) : ordered_json()}};
  out.update(described_json(request.surface));
  return out;
}

double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

ordered_json options_json(const BuildOptions& options) {
  ordered_json correspondence = described_json(options.correspondence);
  correspondence["objective"] = objective_json(options.correspondence);
  if (!registered_together(options.correspondence)) correspondence.erase("group");
  ordered_json out = {{"method", correspondence["method"]},
                      {"objective", correspondence["objective"]},
                      {"lambda", lambda_json(options.correspondence)}};
  for (const ordered_json& part :
       {described_json(options.landmarks), described_json(options.model), correspondence})
    out.update(part);
  return out;
}

ordered_json run_json(const RunDescription& asked, const BuildRecord& record, const Evaluation& evaluation,
                      const RunFigures& figures) {
  const CohortRegistration& cohort = record.built.registration;
  const Landmarks& landmarks = record.built.landmarks;
  ordered_json shapes = ordered_json::array();
  for (std::size_t i = 0; i < record.inputs.size(); ++i) shapes.push_back(shape_json(record, i, evaluation));
  for (const LeftOut& shape : record.left_out)
    shapes.push_back({{"name", shape.stem}, {"status", "left out"}, {"reason", shape.reason.text}});
  ordered_json options = options_json(asked.build);
  const bool from_labels = std::any_of(record.inputs.begin(), record.inputs.end(),
                                       [](const InputShape& input) { return input.label.has_value(); });
  if (from_labels) options["label_maps"] = label_options_json(asked.labels);
  ordered_json stages = ordered_json::object();
  for (const auto& [name, time] : record.built.stage_seconds) stages[name] = time;
  stages["evaluate"] = evaluation.seconds.representation + evaluation.seconds.generalization +
                       evaluation.seconds.specificity + evaluation.seconds.drawn + evaluation.seconds.truth;
  if (evaluation.refit) stages["refit"] = evaluation.seconds.refit;
  return {{"version", version()},
          {"command", asked.command},
          {"options", options},
          {"seed", asked.build.landmarks.seed},
          {"inputs", inputs_json(record)},
          {"reference", cohort.shapes[cohort.reference].name},
          {"template_motion_mm", cohort.template_motion_mm},
          {"unexplained_shares", cohort.unexplained_shares},
          {"description_lengths", cohort.description_lengths},
          {"landmarks", landmarks.mesh.turns.size()},
          {"landmarks_inserted", landmarks.inserted},
          {"self_intersections_before_mending", landmarks.initial_self_intersections},
          {"self_intersections_not_mended", landmarks.remaining_self_intersections},
          {"landmark_triangles", landmarks.mesh.triangles.size()},
          {"shapes", shapes},
          {"seconds", figures.seconds},
          {"seconds_by_stage", stages},
          {"threads", figures.threads},
          {"stages_taken_up", figures.stages_taken_up},
          {"peak_memory_mb", peak_memory_mb()}};
}

}  // namespace foramen
