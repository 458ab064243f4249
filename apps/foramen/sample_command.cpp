#include "command.hpp"
#include "workflow/sample_model.hpp"

namespace foramen::app {
namespace {

struct SampleCommand {
  SampleRequest request;
  Console console;
};

int sample(const SampleCommand& command) {
  const auto notes = sample_model(command.request, command.console.context());
  for (const Message& note : notes) command.console.warn(note);
  tell_written(command.console, command.request.output, command.request.count);
  return ExitCode::done;
}

}  // namespace

void add_sample(CLI::App& program, Run& run) {
  auto options = std::make_shared<SampleCommand>();
  SampleRequest& request = options->request;
  CLI::App* command = program.add_subcommand("sample", "random shapes of a model");
  command->footer("Example:\n  foramen sample model -n 100 --seed 1 -o samples");
  command->add_option("model", request.model, "folder of a model, or its model.h5")->required();
  command->add_option("-o,--output", request.output, "folder to write")->required();
  add_console_options(*command, options->console);
  command->add_option("-n,--samples", request.count, "number of shapes")->check(CLI::Range(1, 10000000));
  command->add_option("--seed", request.seed, "seed of all random numbers");
  command->callback([options, &run] { run = [options] { return sample(*options); }; });
}

}  // namespace foramen::app
