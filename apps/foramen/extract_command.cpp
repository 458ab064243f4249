#include <iostream>
#include <memory>

#include "label_options.hpp"
#include "repair_options.hpp"
#include "workflow/run_extract.hpp"

namespace foramen::app {
namespace {

struct ExtractCommand {
  LabelFlags flags;
  std::optional<LabelRequest> labels;  // set from the flags
  std::vector<std::string> inputs;
  std::string output;
  bool strict = false, repair = false;
  RepairOptions repair_options;
  Console console;
};

int extract(const ExtractCommand& command) {
  ExtractRequest request;
  for (const std::string& input : command.inputs) request.inputs.emplace_back(input);
  request.output = command.output;
  request.labels = command.labels.value_or(LabelRequest{});
  if (command.repair) request.repair = command.repair_options;
  request.canonical_command = command.console.command;
  const ExtractSummary summary = run_extract(request, command.console.context());
  for (const LeftOut& label : summary.left_out)
    command.console.warn(label.reason.about("left out " + source_of(label)));
  for (const Message& note : summary.notes) command.console.warn(note);
  if (command.console.json)
    std::cout << summary.json << '\n';
  else
    command.console.say(summary.text);
  return command.strict && !summary.left_out.empty() ? ExitCode::refused : ExitCode::done;
}

}  // namespace

void add_extract(CLI::App& program, Run& run) {
  auto options = std::make_shared<ExtractCommand>();
  CLI::App* command = program.add_subcommand("extract", "meshes of the labels of label maps");
  command->footer("Example:\n  foramen extract spine.nii.gz --labels 20-24 -o shapes");
  command->add_option("inputs", options->inputs, "label maps (NIfTI, NRRD, MetaImage) or folders of them")
      ->required();
  command->add_option("-o,--output", options->output, "folder to write")->required();
  options->flags.add_to(*command);
  CLI::Option* repair = command->add_flag("--repair", options->repair,
                                          "repair what is not fit for a model (see foramen repair)");
  for (CLI::Option* option : add_repair_options(*command, options->repair_options)) option->needs(repair);
  command->add_flag("--strict", options->strict, "exit 1 if any label is left out");
  add_console_options(*command, options->console);
  command->callback([options, command, &run] {
    options->labels = options->flags.resolved();
    options->console.command = canonical_command(*command, words_of_inputs(options->inputs, find_label_maps));
    run = [options] { return extract(*options); };
  });
}

}  // namespace foramen::app
