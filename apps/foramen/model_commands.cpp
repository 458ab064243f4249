#include <atomic>
#include <cstdio>
#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "core/parallel.hpp"
#include "foramen/io/mesh_file.hpp"
#include "modelfiles/model_folder.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;

struct ModelCommand {
  std::string model, output;
  int count = 10;
  std::uint64_t seed = 1;
  double sd = 2;
  Console console;
};

std::string sample_name(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "sample%04d.ply", index + 1);
  return name;
}

void tell_written(const ModelCommand& command, int files) {
  if (command.console.json)
    std::cout << nlohmann::ordered_json{{"folder", command.output}, {"files", files}}.dump(2) << '\n';
  else
    command.console.say("wrote " + std::to_string(files) + " meshes to " + command.output);
}

int sample(const ModelCommand& command) {
  const LoadedModel loaded = load_model(command.model);
  const RunContext ctx = command.console.context();
  fs::create_directories(command.output);
  const Rng root(command.seed);
  std::atomic<int> done{0};
  parallel_for(command.count, ctx, [&](int i) {
    Rng rng = root.fork(static_cast<std::uint64_t>(i));
    const Eigen::VectorXd shape = loaded.model.reconstruct(loaded.model.draw(rng));
    write_ply(fs::path(command.output) / sample_name(i), {unflattened(shape), loaded.model.triangles()},
              loaded.space);
    ctx.step("sample", static_cast<double>(++done) / command.count);
  });
  tell_written(command, command.count);
  return ExitCode::done;
}

int modes(const ModelCommand& command) {
  const LoadedModel loaded = load_model(command.model);
  write_modes(command.output, loaded.model, command.sd, loaded.space);
  tell_written(command, 2 * loaded.model.modes());
  return ExitCode::done;
}

CLI::App* add_model_command(CLI::App& program, const char* name, const char* what,
                            const std::shared_ptr<ModelCommand>& options) {
  CLI::App* command = program.add_subcommand(name, what);
  command->add_option("model", options->model, "folder of a model, or its model.h5")->required();
  command->add_option("-o,--output", options->output, "folder to write")->required();
  add_console_options(*command, options->console);
  return command;
}

}  // namespace

void add_sample(CLI::App& program, Run& run) {
  auto options = std::make_shared<ModelCommand>();
  CLI::App* command = add_model_command(program, "sample", "random shapes of a model", options);
  command->footer("Example:\n  foramen sample model -n 100 --seed 1 -o samples");
  command->add_option("-n,--samples", options->count, "number of shapes")->check(CLI::Range(1, 10000000));
  command->add_option("--seed", options->seed, "seed of all random numbers");
  command->callback([options, &run] { run = [options] { return sample(*options); }; });
}

void add_modes(CLI::App& program, Run& run) {
  auto options = std::make_shared<ModelCommand>();
  CLI::App* command =
      add_model_command(program, "modes", "the mean +- standard deviations along every mode", options);
  command->footer("Example:\n  foramen modes model --sd 2 -o modes");
  command->add_option("--sd", options->sd, "number of standard deviations")->check(CLI::PositiveNumber);
  command->callback([options, &run] { run = [options] { return modes(*options); }; });
}

}  // namespace foramen::app
