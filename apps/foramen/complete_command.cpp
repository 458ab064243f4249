#include <cstdio>
#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "described_option.hpp"
#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/io/statismo_file.hpp"
#include "io/atomic_file.hpp"
#include "modelfiles/usable_model.hpp"
#include "repair_options.hpp"
#include "workflow/completion.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

struct CompleteCommand {
  std::string model, surface, output;
  LengthUnit unit = LengthUnit::millimetre;
  CompleteSurfaceOptions options;
  Console console;
};

struct Part {
  Mesh mesh;  // mm
  AnatomicalSpace space = AnatomicalSpace::lps;
};

Part read_part(const fs::path& file, LengthUnit unit) {
  MeshFile read = read_mesh(file);
  for (Vec3& p : read.soup.points) p *= millimetres_per(unit);
  try {
    return {usable_part(read.soup), read.space.value_or(AnatomicalSpace::lps)};
  } catch (const TopologyError& e) {
    throw TopologyError(message_of(e).about(file.string()));
  } catch (const InvalidInput& e) {
    throw InvalidInput(message_of(e).about(file.string()));
  }
}

void write_posterior(const fs::path& path, const ShapeDistribution& shape, const UsableModel& model) {
  const ShapeModel modes = principal_model(shape, model.landmarks.triangles);
  StatismoModel file;
  file.points = unflattened(modes.mean());
  file.triangles = modes.triangles();
  file.mean = modes.mean();
  file.basis = modes.basis();
  file.variance = modes.variance();
  file.build_time = build_time();
  file.parameters = {{"command", "foramen complete"}};
  write_statismo(path, file);
}

int complete(const CompleteCommand& command) {
  const RunContext ctx = command.console.context();
  const UsableModel model = read_usable_model(command.model);
  const Part part = read_part(command.surface, command.unit);
  CompleteSurfaceOptions options = command.options;
  options.scale = model.scale;
  ctx.step("complete", 0);
  const CompletedSurface completed = complete_surface(part.mesh, model.aligned.model, ctx, options);
  ctx.step("complete", 1);

  const std::vector<VertexScalar> scalars{
      {"standard_deviation_mm", standard_deviations(completed.shape)},
      {"seen", std::vector<double>(completed.seen.begin(), completed.seen.end())}};
  TriangleSoup soup{unflattened(completed.shape.mean), model.landmarks.triangles};
  for (Vec3& p : soup.points) p /= millimetres_per(command.unit);
  const fs::path folder = command.output;
  fs::create_directories(folder);
  write_ply(folder / "completed.ply", soup, part.space, scalars);
  write_posterior(folder / "posterior.h5", completed.shape, model);

  ordered_json json{{"surface", fs::path(command.surface).filename().string()}};
  json.update(completion_json(completed));
  write_file(folder / "complete.json", json.dump(2) + "\n");
  if (const auto note = completion_note(completed))
    command.console.warn(*note + ": look at " + (folder / "completed.ply").string());
  if (command.console.json) std::cout << json.dump(2) << '\n';
  const auto number = [&](const char* key) { return json.at(key).get<double>(); };
  char text[200];
  std::snprintf(text, sizeof text,
                ": mean distance to the part %.2f mm; %.0f %% of the landmarks seen; standard deviation %.2f "
                "mm where seen, %.2f mm elsewhere",
                number("distance_mm"), 100 * number("seen_share"), number("standard_deviation_seen_mm"),
                number("standard_deviation_unseen_mm"));
  command.console.say((folder / "completed.ply").string() + text);
  return ExitCode::done;
}

}  // namespace

void add_complete(CLI::App& program, Run& run) {
  auto options = std::make_shared<CompleteCommand>();
  CLI::App* command = program.add_subcommand(
      "complete",
      "the whole of a partial or damaged surface, open or closed, in any pose: the model given what is seen, "
      "its mean with the standard deviation everywhere, and the posterior as a model to sample");
  command->footer("Example:\n  foramen complete model damaged.ply -o completed");
  command->add_option("model", options->model, "folder of a model")->required();
  command->add_option("surface", options->surface, "mesh file, its triangles wound outward")->required();
  command->add_option("-o,--output", options->output, "folder to write")->required();
  add_described(*command, "--noise", options->options, "noise");
  add_described(*command, "--beyond-modes", options->options, "beyond_modes");
  add_unit_option(*command, options->unit);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return complete(*options); }; });
}

}  // namespace foramen::app
