#include "workflow/project_files.hpp"

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <optional>

#include <nlohmann/json.hpp>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "inputs/read_cohort.hpp"
#include "io/atomic_file.hpp"
#include "io/table_file.hpp"
#include "workflow/surface_projector.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

// What became of one surface.
struct Projected {
  InputShape input;
  std::optional<Message> failure;
  Projection projection;
};

Projected projected(const ShapeFile& file, const ProjectRequest& request, const SurfaceProjector& projector,
                    const RunContext& ctx) {
  Projected result;
  result.input = read_shape(file.path, request.unit);
  result.input.stem = file.name;
  result.input.file_name = file.shown();
  std::vector<std::string> left_out = request.leave_out;
  const auto& names = projector.model().names;
  if (left_out.empty() && std::find(names.begin(), names.end(), result.input.stem) != names.end())
    left_out = {result.input.stem};
  result.projection = projector(result.input.mesh, left_out, ctx);
  return result;
}

void write_projected(const Projected& p, const UsableModel& model, const ProjectRequest& request) {
  const fs::path& folder = request.output;
  const std::string file = p.input.stem + ".ply";
  const AnatomicalSpace space = p.input.space;
  const auto& triangles = model.landmarks.triangles;
  const auto in_unit = [&](std::span<const Vec3> points) {
    std::vector<Vec3> scaled(points.begin(), points.end());
    for (Vec3& q : scaled) q /= millimetres_per(request.unit.length);
    return scaled;
  };
  const VertexScalar of_fit{"distance_mm", p.projection.fit_residual},
      of_surface{"distance_mm", p.projection.residual};
  write_ply(folder / "corresponding" / file, {in_unit(p.projection.landmarks), triangles}, space);
  write_ply(folder / "fit" / file, {in_unit(p.projection.shape.fit), triangles}, space, {&of_fit, 1});
  write_ply(folder / "residual" / file, {in_unit(p.input.mesh.positions()), p.input.mesh.triangles()}, space,
            {&of_surface, 1});
}

ordered_json projected_json(const Projected& p) {
  ordered_json json{{"shape", p.input.stem}, {"file", p.input.file_name}, {"sha256", p.input.sha256}};
  if (!p.failure)
    json.update(projection_json(p.projection));
  else
    json["failure"] = p.failure->text;
  return json;
}

std::string line_of(const std::string& shape, const Projection& of) {
  char text[160];
  std::snprintf(text, sizeof text, ": distance to the model's fit: mean %.2f, p95 %.2f, largest %.2f mm",
                of.fit.mean, of.fit.p95, of.fit.hausdorff);
  std::string all = shape + text;
  if (const auto& others = of.fit_without_left_out) {
    std::snprintf(text, sizeof text, "; without %s%s: mean %.2f, p95 %.2f, largest %.2f mm",
                  of.left_out.front().c_str(), of.left_out.size() > 1 ? " ..." : "", others->mean,
                  others->p95, others->hausdorff);
    all += text;
  }
  return all;
}

void write_projected_scores(const fs::path& path, const std::vector<Projected>& all, int modes) {
  std::vector<std::string> header{"shape"};
  for (int m = 0; m < modes; ++m) header.push_back("mode" + std::to_string(m + 1));
  std::vector<Row> rows;
  for (const Projected& p : all) {
    if (p.failure) continue;
    Row row{p.input.stem};
    for (const double score : p.projection.shape.scores) row.emplace_back(score);
    rows.push_back(std::move(row));
  }
  write_csv(path, header, rows);
}

// Every surface by itself: one that fails does not stop the others.
std::vector<Projected> all_projected(const std::vector<ShapeFile>& files, const ProjectRequest& request,
                                     const SurfaceProjector& projector, const RunContext& ctx) {
  std::vector<Projected> all(files.size());
  std::atomic<int> done{0};
  parallel_for(static_cast<int>(files.size()), ctx, [&](int i) {
    const std::size_t k = i;
    try {
      all[k] = projected(files[k], request, projector, ctx.without_progress());
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      all[k].input.stem = files[k].name;
      all[k].input.file_name = files[k].shown();
      all[k].failure = reason_without_name(e, files[k].path);
    }
    ctx.step("project", static_cast<double>(++done) / static_cast<double>(files.size()));
  });
  return all;
}

}  // namespace

ProjectSummary project_files(const ProjectRequest& request, const RunContext& ctx) {
  const auto [files, search_notes] = find_meshes(request.surfaces);
  ctx.step("model", 0);
  const SurfaceProjector projector(read_usable_model(request.model), ctx);
  if (!request.leave_out.empty()) projector.without(request.leave_out);  // refused before the work begins
  for (const char* folder : {"corresponding", "fit", "residual"}) make_folder(request.output / folder);
  const std::vector<Projected> all = all_projected(files, request, projector, ctx);
  ProjectSummary summary;
  summary.notes = search_notes;
  ordered_json records = ordered_json::array();
  for (const Projected& p : all) {
    records.push_back(projected_json(p));
    if (!p.failure) {
      summary.notes.insert(summary.notes.end(), p.input.notes.begin(), p.input.notes.end());
      if (p.input.size_note) summary.notes.push_back(p.input.size_note->about(p.input.file_name));
      write_projected(p, projector.model(), request);
      summary.lines.push_back({{line_of(p.input.stem, p.projection)}});
    } else {
      summary.lines.push_back({p.failure->about(p.input.file_name), true});
    }
  }
  write_projected_scores(request.output / "scores.csv", all, projector.model().aligned.model.modes());
  summary.json = ordered_json{{"shapes", records}}.dump(2);
  write_file(request.output / "project.json", summary.json + "\n");
  return summary;
}

}  // namespace foramen
