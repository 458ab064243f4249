#include <iostream>

#include "command.hpp"
#include "described_option.hpp"
#include "repair_options.hpp"
#include "workflow/complete_file.hpp"

namespace foramen::app {
namespace {

struct CompleteCommand {
  CompleteRequest request;
  Console console;
};

int complete(const CompleteCommand& command) {
  const Console& console = command.console;
  const CompleteSummary summary = complete_file(command.request, console.context());
  for (const Message& note : summary.notes) console.warn(note);
  if (console.json) std::cout << summary.json << '\n';
  console.say(summary.text);
  return ExitCode::done;
}

}  // namespace

void add_complete(CLI::App& program, Run& run) {
  auto options = std::make_shared<CompleteCommand>();
  CompleteRequest& request = options->request;
  CLI::App* command = program.add_subcommand(
      "complete",
      "the whole of a partial or damaged surface, open or closed, in any pose: the model given what is seen, "
      "its mean with the standard deviation everywhere, and the posterior as a model to sample");
  command->footer("Example:\n  foramen complete model damaged.ply -o completed");
  command->add_option("model", request.model, "folder of a model")->required();
  command->add_option("surface", request.surface, "mesh file, its triangles wound outward")->required();
  command->add_option("-o,--output", request.output, "folder to write")->required();
  add_described(*command, "--noise", request.options, "noise");
  add_described(*command, "--beyond-modes", request.options, "beyond_modes");
  add_unit_option(*command, request.unit);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return complete(*options); }; });
}

}  // namespace foramen::app
