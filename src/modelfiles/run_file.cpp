#include "modelfiles/run_file.hpp"

#include <fstream>
#include <iterator>
#include <utility>

#include "modelfiles/extraction_record.hpp"

namespace foramen {

using nlohmann::ordered_json;

template <class Fields>
void list_fields(Fields& fields, MaybeConst<RunInput> auto& input) {
  fields("file", input.file);
  fields("sha256", input.sha256);
  fields.if_there("vertices", input.vertices);
  fields.if_there("triangles", input.triangles);
  fields.if_there("label", input.label);
  fields.if_there("names_from", input.names_from);
  fields.if_there("extraction", input.extraction);
}

template <class Fields>
void list_fields(Fields& fields, MaybeConst<RunCertificate> auto& c) {
  fields.if_there("mesh", c.mesh);
  fields.if_there("triangles", c.triangles);
  fields.if_there("flipped", c.flipped);
  fields.if_there("smallest_area_ratio", c.smallest_area_ratio);
  fields.if_there("largest_area_ratio", c.largest_area_ratio);
  fields.if_there("degree", c.degree);
  fields.if_there("homology_matrix", c.homology);
  fields.if_there("seifert_matrix", c.seifert);
  fields.if_there("reference_seifert_matrix", c.reference_seifert);
  fields.if_there("map_agreement", c.agreement);
}

template <class Fields>
void list_fields(Fields& fields, MaybeConst<RunMap> auto& map) {
  fields.if_there("iterations", map.iterations);
  fields.if_there("energy_initial", map.initial_energy);
  fields.if_there("energy_final", map.final_energy);
  fields("distortion", map.distortion);
  fields.if_there("certificate", map.certificate);
}

template <class Fields>
void list_fields(Fields& fields, MaybeConst<UsedShape> auto& f) {
  fields.if_there("seconds", f.seconds);
  fields.if_there("alignment_residual_mm", f.alignment_residual_mm);
  fields.if_there("repair", f.repair);
  fields.inlined("distortion", f.map);
  fields.if_there("landmarks_without_compatible_point", f.without_compatible_point);
  fields("flips_in_map", f.flips_in_map);
  fields.if_there("flips_sampled_plain", f.plain_flips);
  fields.if_there("flips_sampled_confirmed", f.confirmed_flips);
  fields.if_there("triangles_opposing_mean", f.opposing_mean);
  fields.if_there("self_intersections", f.self_intersections);
  fields.if_there("input_self_intersections", f.input_self_intersections);
}

template <class Fields>
void list_fields(Fields& fields, MaybeConst<RunShape> auto& shape) {
  fields("name", shape.name);
  fields("status", shape.status);
  fields("reason", shape.reason);
  fields.inlined("flips_in_map", shape.used);
}

inline void list_fields(JsonFieldWriter& fields, const RunOptions& options) {
  for (const auto& [name, value] : options.by_name().items()) fields(name.c_str(), value);
}
inline void list_fields(JsonFieldReader& fields, RunOptions& options) { options = RunOptions(fields.all()); }

template <class Fields>
void list_fields(Fields& fields, MaybeConst<RunRecord> auto& r) {
  fields("version", r.version);
  fields("command", r.command);
  fields("options", r.options);
  fields.if_there("seed", r.seed);
  fields("inputs", r.inputs);
  fields("reference", r.reference);
  fields.if_there("template_motion_mm", r.template_motion_mm);
  fields.if_there("unexplained_shares", r.unexplained_shares);
  fields.if_there("description_lengths", r.description_lengths);
  fields.if_there("landmarks", r.landmarks);
  fields("landmarks_inserted", r.landmarks_inserted);
  fields.if_there("self_intersections_before_mending", r.self_intersections_before_mending);
  fields.if_there("self_intersections_not_mended", r.self_intersections_not_mended);
  fields("landmark_triangles", r.landmark_triangles);
  fields("shapes", r.shapes);
  fields.if_there("seconds", r.seconds);
  fields.if_there("seconds_by_stage", r.seconds_by_stage);
  fields.if_there("threads", r.threads);
  fields.if_there("stages_taken_up", r.stages_taken_up);
  fields.if_there("peak_memory_mb", r.peak_memory_mb);
}

namespace {

void require_figures(const RunRecord& record) {
  for (const RunShape& shape : record.shapes)
    if (!shape.used && shape.status != ShapeStatus::left_out)
      throw InvalidInput("the shape " + shape.name + " is part of the model, but flips_in_map is missing");
}

}  // namespace

RunOptions::RunOptions(ordered_json by_name) : by_name_(std::move(by_name)) {
  const PlacedJson options(by_name_, "options");
  options.field("method").read(method_);
  options.field("objective").read(objective_);
  options.field("scale").read(scale_);
}

std::string run_json(const RunRecord& record) { return json_of(record).dump(2); }

RunRecord parse_run(const std::string& text, const std::string& name) {
  constexpr const char* remedy = "; the file is damaged or of another version: build the model again";
  try {
    const ordered_json json = ordered_json::parse(text);
    RunRecord record;
    PlacedJson(json, "").read(record);
    require_figures(record);
    return record;
  } catch (const nlohmann::json::parse_error& e) {
    throw IoError(name + ": is not JSON (byte " + std::to_string(e.byte) + ")" + remedy);
  } catch (const nlohmann::json::exception& e) {
    throw IoError(name + ": " + e.what() + remedy);
  } catch (const InvalidInput& e) {
    throw IoError(name + ": " + e.what() + remedy);
  }
}

RunRecord read_run(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "run.json";
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw IoError(file.string() + ": cannot be read; the build of a model writes it",
                  {{RemedyKind::build_model}});
  return parse_run({std::istreambuf_iterator<char>(in), {}}, file.string());
}

}  // namespace foramen
