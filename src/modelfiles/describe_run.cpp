#include "modelfiles/describe_run.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <utility>

#include "foramen/correspond/registration_frame.hpp"
#include "modelfiles/extraction_record.hpp"
#include "modelfiles/options_json.hpp"
#include "modelfiles/version.hpp"

namespace foramen {
namespace {

using nlohmann::ordered_json;

RunCertificate certificate_of(const ShapeRegistration& shape, const ReferenceLoops& reference) {
  const MapCertificate& c = shape.certificate;
  return {.triangles = c.triangles,
          .flipped = c.flipped,
          .smallest_area_ratio = c.smallest_area_ratio,
          .largest_area_ratio = c.largest_area_ratio,
          .degree = c.degree,
          .homology = shape.homology,
          .seifert = shape.seifert,
          .reference_seifert = reference.seifert,
          .agreement = shape.agreement};
}

UsedShape used_shape(const BuildRecord& record, std::size_t i, const Evaluation& evaluation) {
  const CohortRegistration& cohort = record.built.registration;
  const ShapeRegistration& shape = cohort.shapes[i];
  const ShapeRepresentation& r = evaluation.representation.shapes[i];
  UsedShape used{.seconds = shape.seconds,
                 .alignment_residual_mm = shape.alignment.residual,
                 .plain_flips = r.plain_flips,
                 .confirmed_flips = r.confirmed_flips,
                 .opposing_mean = r.opposing_mean,
                 .self_intersections = r.self_intersections,
                 .input_self_intersections = r.input_self_intersections};
  if (record.inputs[i].repair) used.repair = recorded(*record.inputs[i].repair);
  if (shape.mapped) {
    used.map = {shape.iterations, shape.initial_energy, shape.final_energy, shape.distortion,
                certificate_of(shape, cohort.frame.reference.loops)};
    used.flips_in_map = shape.certificate.flipped;
  } else {
    used.without_compatible_point = record.built.landmarks.without_compatible[i];
  }
  return used;
}

std::string remark_on(const InputShape& input) {
  if (input.repair) return "repaired: " + summary(*input.repair);
  return input.was_inward ? "wound inward; reversed" : "";
}

std::vector<RunShape> shapes_of(const BuildRecord& record, const Evaluation& evaluation) {
  std::vector<RunShape> shapes;
  for (std::size_t i = 0; i < record.inputs.size(); ++i) {
    const bool is_reference = static_cast<int>(i) == record.built.registration.reference;
    shapes.push_back({record.inputs[i].stem, is_reference ? ShapeStatus::reference : ShapeStatus::used,
                      remark_on(record.inputs[i]), used_shape(record, i, evaluation)});
  }
  for (const LeftOut& shape : record.left_out)
    shapes.push_back({shape.stem, ShapeStatus::left_out, shape.reason.text, std::nullopt});
  return shapes;
}

std::vector<RunInput> inputs_of(const BuildRecord& record) {
  std::vector<RunInput> inputs;
  for (const InputShape& input : record.inputs) {
    inputs.push_back({.file = input.file_name,
                      .sha256 = input.sha256,
                      .vertices = input.mesh.vertex_count(),
                      .triangles = input.mesh.face_count(),
                      .label = input.label});
    if (!input.label) continue;
    inputs.back().names_from = input.names_from;
    inputs.back().extraction = input.extraction;
  }
  for (const LeftOut& shape : record.left_out)
    inputs.push_back({.file = shape.file_name, .sha256 = shape.sha256, .label = shape.label});
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

// Largest resident memory of this process so far, MB.
double peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

RunOptions options_of(const RunDescription& asked, const BuildRecord& record) {
  ordered_json options = options_json(asked.build);
  const bool from_labels = std::any_of(record.inputs.begin(), record.inputs.end(),
                                       [](const InputShape& input) { return input.label.has_value(); });
  if (from_labels) options["label_maps"] = label_options_json(asked.labels);
  return RunOptions(std::move(options));
}

NamedNumbers seconds_by_stage(const BuildRecord& record, const Evaluation& evaluation) {
  const EvaluationSeconds& s = evaluation.seconds;
  NamedNumbers seconds = record.built.stage_seconds;
  seconds.emplace_back("evaluate", s.representation + s.generalization + s.specificity + s.drawn + s.truth);
  if (evaluation.refit) seconds.emplace_back("refit", s.refit);
  return seconds;
}

}  // namespace

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

RunRecord describe_run(const RunDescription& asked, const BuildRecord& record, const Evaluation& evaluation,
                       const RunFigures& figures) {
  const CohortRegistration& cohort = record.built.registration;
  const Landmarks& landmarks = record.built.landmarks;
  return {.version = version(),
          .command = asked.command,
          .options = options_of(asked, record),
          .seed = asked.build.landmarks.seed,
          .inputs = inputs_of(record),
          .reference = cohort.shapes[cohort.reference].name,
          .template_motion_mm = cohort.template_motion_mm,
          .unexplained_shares = cohort.unexplained_shares,
          .description_lengths = cohort.description_lengths,
          .landmarks = static_cast<int>(landmarks.mesh.turns.size()),
          .landmarks_inserted = landmarks.inserted,
          .self_intersections_before_mending = landmarks.initial_self_intersections,
          .self_intersections_not_mended = landmarks.remaining_self_intersections,
          .landmark_triangles = static_cast<int>(landmarks.mesh.triangles.size()),
          .shapes = shapes_of(record, evaluation),
          .seconds = figures.seconds,
          .seconds_by_stage = seconds_by_stage(record, evaluation),
          .threads = figures.threads,
          .stages_taken_up = figures.stages_taken_up,
          .peak_memory_mb = peak_memory_mb()};
}

}  // namespace foramen
