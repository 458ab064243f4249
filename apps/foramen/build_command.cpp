#include <iostream>
#include <memory>

#include "build_options.hpp"
#include "foramen/core/error.hpp"

namespace foramen::app {
namespace {

struct BuildCommand {
  BuildArguments arguments;
  BuildRequest request;  // set from the arguments
  std::vector<std::string> inputs;
  std::string output;
  bool strict = false;
  Console console;
};

int build(const BuildCommand& command) {
  try {
    return print_build(run_build(command.request, command.console.context()), command.console,
                       command.strict);
  } catch (const Cancelled&) {
    command.console.warn("the same command with --resume goes on from here");
    throw;
  }
}

}  // namespace

int print_build(const BuildSummary& summary, const Console& console, bool strict) {
  for (const LeftOut& shape : summary.left_out)
    console.warn(shape.reason.about("left out " + source_of(shape)));
  for (const Message& note : summary.notes) console.warn(note);
  if (console.json)
    std::cout << summary.json << '\n';
  else
    console.say(summary.text);
  return strict && !summary.left_out.empty() ? ExitCode::refused : ExitCode::done;
}

void add_build(CLI::App& program, Run& run) {
  auto options = std::make_shared<BuildCommand>();
  CLI::App* command = program.add_subcommand(
      "build", "a statistical shape model from surfaces or label maps, with its evaluation and report");
  command->footer(
      "Examples:\n  foramen build shapes/ -o model\n  foramen build spine.nii.gz --labels 20-24 -o model     "
      " (a label map: L1 to L5)\n  foramen build shapes/ --repair --subject-regex '^([^_]+)' -o model");
  command->add_option("inputs", options->inputs, "mesh files, label maps, or folders of them")->required();
  command->add_option("-o,--output", options->output, "folder of the model")->required();
  options->arguments.add_to(*command);
  command->add_flag("--strict", options->strict, "exit 1 if any shape is left out");
  add_console_options(*command, options->console);
  command->callback([options, command, &run] {
    options->console.command =
        canonical_command(*command, words_of_inputs(options->inputs, find_shape_files));
    options->request = options->arguments.request(options->inputs, options->output, options->console.command);
    run = [options] { return build(*options); };
  });
}

}  // namespace foramen::app
