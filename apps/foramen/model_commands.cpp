#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "modelfiles/model_folder.hpp"
#include "workflow/sample_model.hpp"

namespace foramen::app {
namespace {

struct SampleCommand {
  SampleRequest request;
  Console console;
};

struct ModesCommand {
  std::filesystem::path model, output;
  double sd = 2;
  Console console;
};

int sample(const SampleCommand& command) {
  const auto notes = sample_model(command.request, command.console.context());
  for (const Message& note : notes) command.console.warn(note.about(command.request.model.string()));
  tell_written(command.console, command.request.output, command.request.count);
  return ExitCode::done;
}

int modes(const ModesCommand& command) {
  const LoadedModel loaded = load_model(command.model);
  for (const Message& note : loaded.notes) command.console.warn(note.about(command.model.string()));
  write_modes(command.output, loaded.model, command.sd, loaded.space);
  tell_written(command.console, command.output, 2 * loaded.model.modes());
  return ExitCode::done;
}

CLI::App* add_model_command(CLI::App& program, const char* name, const char* what,
                            std::filesystem::path& model, std::filesystem::path& output, Console& console) {
  CLI::App* command = program.add_subcommand(name, what);
  command->add_option("model", model, "folder of a model, or its model.h5")->required();
  command->add_option("-o,--output", output, "folder to write")->required();
  add_console_options(*command, console);
  return command;
}

}  // namespace

void tell_written(const Console& console, const std::filesystem::path& folder, int files) {
  if (console.json)
    std::cout << nlohmann::ordered_json{{"folder", folder.string()}, {"files", files}}.dump(2) << '\n';
  else
    console.say("wrote " + std::to_string(files) + " meshes to " + folder.string());
}

void add_sample(CLI::App& program, Run& run) {
  auto options = std::make_shared<SampleCommand>();
  SampleRequest& request = options->request;
  CLI::App* command = add_model_command(program, "sample", "random shapes of a model", request.model,
                                        request.output, options->console);
  command->footer("Example:\n  foramen sample model -n 100 --seed 1 -o samples");
  command->add_option("-n,--samples", request.count, "number of shapes")->check(CLI::Range(1, 10000000));
  command->add_option("--seed", request.seed, "seed of all random numbers");
  command->callback([options, &run] { run = [options] { return sample(*options); }; });
}

void add_modes(CLI::App& program, Run& run) {
  auto options = std::make_shared<ModesCommand>();
  CLI::App* command = add_model_command(program, "modes", "the mean +- standard deviations along every mode",
                                        options->model, options->output, options->console);
  command->footer("Example:\n  foramen modes model --sd 2 -o modes");
  command->add_option("--sd", options->sd, "number of standard deviations")->check(CLI::PositiveNumber);
  command->callback([options, &run] { run = [options] { return modes(*options); }; });
}

}  // namespace foramen::app
