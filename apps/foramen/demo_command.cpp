#include "build_options.hpp"
#include "workflow/run_demo.hpp"

namespace foramen::app {
namespace {

struct DemoCommand {
  DemoRequest request;
  BuildFlags flags;  // part of the request is set from them
  Console console;
};

int demo(const DemoCommand& command) {
  const Console& console = command.console;
  const SynthOptions& synth = command.request.synth;
  console.say("making " + std::to_string(synth.shapes) + " vertebra-like shapes (seed " +
              std::to_string(synth.seed) + ")");
  const DemoSummary summary = run_demo(command.request, console.context());
  const int code = print_build(summary.build, console, true);
  console.say(summary.report.string());
  return code;
}

}  // namespace

void add_demo(CLI::App& program, Run& run) {
  auto options = std::make_shared<DemoCommand>();
  DemoRequest& request = options->request;
  request.output = "foramen-demo";
  request.canonical_command = "foramen demo";
  options->flags.choices.samples = 100;  // fewer than a build, so that the demo takes a minute
  CLI::App* command = program.add_subcommand(
      "demo", "a synthetic cohort, its model and report: needs no input, ends with the report's path");
  command->footer("Example:\n  foramen demo -n 8");
  command->add_option("-n,--shapes", request.synth.shapes, "number of shapes")->check(CLI::Range(3, 1000));
  options->flags.add_to(*command);
  command->add_option("-o,--output", request.output, "folder to write")->capture_default_str();
  add_console_options(*command, options->console);
  command->callback([options, &run] {
    DemoRequest& resolved = options->request;
    resolved.evaluation = evaluation_options(options->flags.choices);
    resolved.synth.seed = resolved.evaluation.seed;
    resolved.build = options->flags.resolved();
    run = [options] { return demo(*options); };
  });
}

}  // namespace foramen::app
