#include "command.hpp"
#include "workflow/write_mode_shapes.hpp"

namespace foramen::app {
namespace {

struct ModesCommand {
  ModeShapesRequest request;
  Console console;
};

int modes(const ModesCommand& command) {
  const ModeShapesSummary summary = write_mode_shapes(command.request);
  for (const Message& note : summary.notes) command.console.warn(note);
  tell_written(command.console, command.request.output, summary.files);
  return ExitCode::done;
}

}  // namespace

void add_modes(CLI::App& program, Run& run) {
  auto options = std::make_shared<ModesCommand>();
  ModeShapesRequest& request = options->request;
  CLI::App* command = program.add_subcommand("modes", "the mean +- standard deviations along every mode");
  command->footer("Example:\n  foramen modes model --sd 2 -o modes");
  command->add_option("model", request.model, "folder of a model, or its model.h5")->required();
  command->add_option("-o,--output", request.output, "folder to write")->required();
  add_console_options(*command, options->console);
  command->add_option("--sd", request.sd, "number of standard deviations")->check(CLI::PositiveNumber);
  command->callback([options, &run] { run = [options] { return modes(*options); }; });
}

}  // namespace foramen::app
