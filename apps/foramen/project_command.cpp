#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/parallel.hpp"
#include "inputs/read_cohort.hpp"
#include "io/atomic_file.hpp"
#include "io/table_file.hpp"
#include "repair_options.hpp"
#include "workflow/surface_projector.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct ProjectCommand {
  std::string model, output;
  std::vector<std::string> surfaces, leave_out;
  LengthUnit unit = LengthUnit::millimetre;
  Console console;
};

// The result for one surface.
struct Projected {
  InputShape input;
  std::string failure;  // empty: no failure
  Projection projection;
};

Projected projected(const fs::path& file, const ProjectCommand& command, const SurfaceProjector& projector,
                    const RunContext& ctx) {
  Projected result;
  result.input = read_shape(file, command.unit);
  std::vector<std::string> left_out = command.leave_out;
  const auto& names = projector.model().names;
  if (left_out.empty() && std::find(names.begin(), names.end(), result.input.stem) != names.end())
    left_out = {result.input.stem};
  result.projection = projector(result.input.mesh, left_out, ctx);
  return result;
}

void write_meshes(const Projected& p, const UsableModel& model, const ProjectCommand& command) {
  const fs::path folder = command.output;
  const std::string file = p.input.stem + ".ply";
  const AnatomicalSpace space = p.input.space;
  const auto& triangles = model.landmarks.triangles;
  const auto in_unit = [&](std::span<const Vec3> points) {
    std::vector<Vec3> scaled(points.begin(), points.end());
    for (Vec3& q : scaled) q /= millimetres_per(command.unit);
    return scaled;
  };
  const VertexScalar of_fit{"distance_mm", p.projection.fit_residual},
      of_surface{"distance_mm", p.projection.residual};
  write_ply(folder / "corresponding" / file, {in_unit(p.projection.landmarks), triangles}, space);
  write_ply(folder / "fit" / file, {in_unit(p.projection.shape.fit), triangles}, space, {&of_fit, 1});
  write_ply(folder / "residual" / file, {in_unit(p.input.mesh.positions()), p.input.mesh.triangles()}, space,
            {&of_surface, 1});
}

ordered_json record(const Projected& p) {
  ordered_json json{{"shape", p.input.stem}, {"file", p.input.file_name}, {"sha256", p.input.sha256}};
  if (p.failure.empty())
    json.update(projection_json(p.projection));
  else
    json["failure"] = p.failure;
  return json;
}

std::string line(const std::string& shape, const Projection& of) {
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

void write_scores(const fs::path& path, const std::vector<Projected>& all, int modes) {
  std::vector<std::string> header{"shape"};
  for (int m = 0; m < modes; ++m) header.push_back("mode" + std::to_string(m + 1));
  std::vector<Row> rows;
  for (const Projected& p : all) {
    if (!p.failure.empty()) continue;
    Row row{p.input.stem};
    for (const double score : p.projection.shape.scores) row.emplace_back(score);
    rows.push_back(std::move(row));
  }
  write_csv(path, header, rows);
}

int project(const ProjectCommand& command) {
  const RunContext ctx = command.console.context();
  const std::vector<fs::path> files = find_meshes({command.surfaces.begin(), command.surfaces.end()});
  ctx.step("model", 0);
  const SurfaceProjector projector(read_usable_model(command.model), ctx);
  // Unknown names are refused before the work begins.
  if (!command.leave_out.empty()) projector.without(command.leave_out);
  std::vector<Projected> all(files.size());
  std::atomic<int> done{0};
  parallel_for(static_cast<int>(files.size()), ctx, [&](int i) {
    const std::size_t k = i;
    try {
      all[k] = projected(files[k], command, projector, ctx.without_progress());
    } catch (const Cancelled&) {
      throw;
    } catch (const Error& e) {
      all[k].input.stem = files[k].stem().string();
      all[k].input.file_name = files[k].filename().string();
      all[k].failure = e.what();
    }
    ctx.step("project", static_cast<double>(++done) / static_cast<double>(files.size()));
  });
  for (const char* folder : {"corresponding", "fit", "residual"})
    fs::create_directories(fs::path(command.output) / folder);
  ordered_json records = ordered_json::array();
  bool failed = false;
  for (const Projected& p : all) {
    records.push_back(record(p));
    if (p.failure.empty()) {
      write_meshes(p, projector.model(), command);
      command.console.say(line(p.input.stem, p.projection));
    } else {
      failed = true;
      command.console.warn(p.input.file_name + ": " + p.failure);
    }
  }
  write_scores(fs::path(command.output) / "scores.csv", all, projector.model().aligned.model.modes());
  const std::string json = ordered_json{{"shapes", records}}.dump(2);
  write_file(fs::path(command.output) / "project.json", json + "\n");
  if (command.console.json) std::cout << json << '\n';
  return failed ? ExitCode::refused : ExitCode::done;
}

}  // namespace

void add_project(CLI::App& program, Run& run) {
  auto options = std::make_shared<ProjectCommand>();
  CLI::App* command = program.add_subcommand(
      "project",
      "what a model says of new surfaces, closed and in any pose: registers each to the mean, gives its "
      "landmarks, scores, the model's closest shape and how far it is, everywhere");
  command->footer("Example:\n  foramen project model new/L2.ply -o projected");
  command->add_option("model", options->model, "folder of a model")->required();
  command->add_option("surfaces", options->surfaces, "mesh files, or folders of them")->required();
  command->add_option("-o,--output", options->output, "folder to write")->required();
  command
      ->add_option("--leave-out", options->leave_out,
                   "training shapes to leave out of the model for a second distance, comma-separated "
                   "(default: the one of the surface's own name)")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_unit_option(*command, options->unit);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return project(*options); }; });
}

}  // namespace foramen::app
