#include "workflow/run_extract.hpp"

#include <cstdio>
#include <set>

#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "inputs/label_map_notes.hpp"
#include "inputs/surface_size.hpp"
#include "io/atomic_file.hpp"
#include "modelfiles/extraction_record.hpp"
#include "modelfiles/repair_record.hpp"
#include "modelfiles/version.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

std::string line_of(const LabelSurface& label) {
  const ExtractionReport& r = label.extracted.report;
  char text[256];
  std::snprintf(
      text, sizeof text,
      "%s: %zu vertices, genus %d, %.0f mm^3 (voxels %+.2f %%); from the voxels p95 %.2f, largest %.2f "
      "voxels (%.2f, %.2f mm)\n",
      label.stem.c_str(), label.extracted.surface.points.size(), r.genus, r.volume,
      100 * (r.volume / r.voxel_volume - 1), r.deviation.p95, r.deviation.hausdorff, r.deviation_mm.p95,
      r.deviation_mm.hausdorff);
  return text;
}

// One surface in the form in which it will be written.
struct Finished {
  std::string stem;
  TriangleSoup surface;
  ordered_json record;
};

Finished finish(const LabelSurface& label, const std::optional<RepairOptions>& repair, const RunContext& ctx,
                std::vector<Message>& notes) {
  TriangleSoup surface = label.extracted.surface;
  auto obstacle = obstacle_to_model(inspect_mesh(surface));
  ordered_json repaired_json;
  if (obstacle && repair) {
    try {
      const RepairedMesh repaired = repair_surface(surface, LengthUnit::millimetre, *repair, ctx);
      notes.push_back(label.stem + ": repaired: " + summary(repaired.report));
      repaired_json = repair_json(repaired.report);
      surface = repaired.mesh.soup();
      obstacle.reset();
    } catch (const InvalidInput& e) {
      notes.push_back(message_of(e).about(label.stem + ": cannot be repaired"));
    }
  } else if (obstacle) {
    notes.push_back(obstacle->message().about(label.stem + ": not fit for a model"));
  }
  if (const auto doubt = doubt_about_label(bounding_box(surface.points).diagonal()))
    notes.push_back(doubt->about(label.stem));
  ordered_json record = {{"file", label.stem + ".ply"},
                         {"label", label.label},
                         {"name", label.name},
                         {"usable", !obstacle},
                         {"vertices", surface.points.size()},
                         {"triangles", surface.triangles.size()},
                         {"extraction", extraction_json(label.extracted.report)}};
  if (!repaired_json.is_null()) record["repair"] = std::move(repaired_json);
  if (obstacle) {
    record["finding"] = obstacle->finding;
    record["remedy"] = obstacle->advice;
  }
  return {label.stem, std::move(surface), std::move(record)};
}

struct ReadLabelMap {
  ShapeFile file;
  LabelSurfaces labels;
};

// Reads all label maps. If there are several, one that cannot be read is replaced by the reason.
std::vector<ReadLabelMap> read_all(const ExtractRequest& request, const RunContext& ctx,
                                   ExtractSummary& summary) {
  std::vector<ReadLabelMap> all;
  const auto [files, search_notes] = find_label_maps(request.inputs);
  summary.notes = search_notes;
  for (std::size_t i = 0; i < files.size(); ++i) {
    ctx.step("extract", static_cast<double>(i) / static_cast<double>(files.size()), files[i].shown());
    try {
      all.push_back({files[i], extract_labels(files[i].label_map(), request.labels, ctx)});
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      if (files.size() == 1) throw;
      summary.left_out.push_back(
          {files[i].name, files[i].shown(), {}, reason_without_name(e, files[i].path)});
      continue;
    }
    for (const RefusedLabel& refused : all.back().labels.refused)
      if (refused.absent)
        throw InvalidInput(
            refused.reason.about(files[i].path.string() + ": label " + std::to_string(refused.label)));
  }
  return all;
}

}  // namespace

ExtractSummary run_extract(const ExtractRequest& request, const RunContext& ctx) {
  ExtractSummary summary;
  const auto all = read_all(request, ctx, summary);
  ordered_json files = ordered_json::array();
  std::vector<Finished> surfaces;
  LabelMapNotes common;
  for (const ReadLabelMap& map : all) {
    const std::string name = map.file.shown();
    common.add(map.file.path, map.labels);
    ordered_json written = ordered_json::array(), refused_labels = ordered_json::array();
    summary.notes.insert(summary.notes.end(), map.labels.notes.begin(), map.labels.notes.end());
    for (const RefusedLabel& refused : map.labels.refused) {
      summary.left_out.push_back({refused.stem, name, map.labels.sha256, refused.reason, refused.label});
      refused_labels.push_back(
          {{"label", refused.label}, {"name", refused.name}, {"reason", refused.reason.text}});
    }
    for (const LabelSurface& label : map.labels.surfaces) {
      ctx.check();
      summary.text += line_of(label);
      surfaces.push_back(finish(label, request.repair, ctx, summary.notes));
      written.push_back(surfaces.back().record);
    }
    files.push_back({{"file", name},
                     {"sha256", map.labels.sha256},
                     {"names_from", map.labels.names_from},
                     {"surfaces", written},
                     {"refused", refused_labels}});
    if (map.labels.passed_over) files.back()["passed_over"] = *map.labels.passed_over;
  }
  const auto notes = common.messages();
  summary.notes.insert(summary.notes.end(), notes.begin(), notes.end());
  if (surfaces.empty()) {
    Message message(std::string("no label could be extracted"));
    for (const LeftOut& out : summary.left_out)
      message.append(out.reason.about("\n  left out " + source_of(out)));
    for (const Message& note : common.on_passed_over()) message.append({"\n  " + note.text, note.remedies});
    throw InvalidInput(message);
  }

  make_folder(request.output);
  for (const Finished& surface : surfaces)
    write_ply(request.output / (surface.stem + ".ply"), surface.surface);
  ordered_json record = {{"version", version()},
                         {"command", request.canonical_command},
                         {"options", label_options_json(request.labels)},
                         {"files", files},
                         {"notes", texts_of(summary.notes)}};
  summary.json = record.dump(2);
  write_file(request.output / "extract.json", summary.json + "\n");
  summary.text += "wrote " + std::to_string(surfaces.size()) +
                  (surfaces.size() == 1 ? " surface to " : " surfaces to ") + request.output.string();
  ctx.step("extract", 1);
  return summary;
}

}  // namespace foramen
