#include "build_options.hpp"
#include "shape_options.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;

struct DemoCommand {
  SynthOptions synth;
  BuildFlags flags;
  BuildOptions build;  // set from the flags
  std::string output = "foramen-demo";
  Console console;
};

int demo(const DemoCommand& command) {
  const fs::path folder = command.output;
  const Console& console = command.console;
  console.say("making " + std::to_string(command.synth.shapes) + " vertebra-like shapes (seed " +
              std::to_string(command.synth.seed) + ")");
  write_synth_cohort(synth_cohort(command.synth, console.context()), folder);

  BuildRequest request;
  request.inputs = {folder / "shapes"};
  request.output = folder / "model";
  request.truth = folder / "truth";
  request.build = command.build;
  request.evaluation = evaluation_options(command.flags.choices);
  request.canonical_command = "foramen demo";
  const int code = finish_build(request, console, true);
  console.say((folder / "model" / "report.html").string());
  return code;
}

}  // namespace

void add_demo(CLI::App& program, Run& run) {
  auto options = std::make_shared<DemoCommand>();
  options->flags.choices.samples = 100;  // fewer than a build, so that the demo takes a minute
  CLI::App* command = program.add_subcommand(
      "demo", "a synthetic cohort, its model and report: needs no input, ends with the report's path");
  command->footer("Example:\n  foramen demo -n 8");
  command->add_option("-n,--shapes", options->synth.shapes, "number of shapes")->check(CLI::Range(3, 1000));
  options->flags.add_to(*command);
  command->add_option("-o,--output", options->output, "folder to write")->capture_default_str();
  add_console_options(*command, options->console);
  command->callback([options, &run] {
    options->synth.seed = evaluation_options(options->flags.choices).seed;
    options->build = options->flags.resolved();
    run = [options] { return demo(*options); };
  });
}

}  // namespace foramen::app
