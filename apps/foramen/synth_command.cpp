#include "command.hpp"
#include "described_option.hpp"
#include "workflow/write_synth_cohort.hpp"

namespace foramen::app {
namespace {

struct SynthCommand {
  SynthRequest request;
  Console console;
};

int synth(const SynthCommand& command) {
  const SynthSummary written = write_synth_cohort(command.request, command.console.context());
  command.console.say("wrote " + std::to_string(written.shapes) + " shapes to " + written.surfaces.string() +
                      " and their true correspondence to " + written.truth.string());
  return ExitCode::done;
}

}  // namespace

void add_synth(CLI::App& program, Run& run) {
  auto options = std::make_shared<SynthCommand>();
  SynthOptions& shapes = options->request.options;
  CLI::App* command = program.add_subcommand("synth", "vertebra-like shapes with known correspondence");
  command->footer("Example:\n  foramen synth -n 14 --seed 1 -o cohort");
  add_described(*command, "-n,--shapes", shapes, "shapes");
  add_described(*command, "--seed", shapes, "seed");
  add_described(*command, "--deformation", shapes, "deformation");
  add_described(*command, "--modes", shapes, "modes");
  add_described(*command, "--amplitude", shapes, "amplitude");
  add_described(*command, "--correlation", shapes, "correlation");
  add_described(*command, "--vertices", shapes, "vertices");
  command->add_option("-o,--output", options->request.output, "folder to write")->required();
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return synth(*options); }; });
}

}  // namespace foramen::app
