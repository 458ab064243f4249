#include <iostream>

#include "command.hpp"
#include "workflow/write_comparison.hpp"

namespace foramen::app {
namespace {

struct CompareCommand {
  ComparisonRequest request;
  Console console;
};

int compare(const CompareCommand& command) {
  const ComparisonSummary summary = write_comparison(command.request);
  if (command.console.json)
    std::cout << summary.json << '\n';
  else
    command.console.say(summary.text);
  command.console.say("wrote " + summary.page.string());
  return ExitCode::done;
}

}  // namespace

void add_compare(CLI::App& program, Run& run) {
  auto options = std::make_shared<CompareCommand>();
  ComparisonRequest& request = options->request;
  CLI::App* command = program.add_subcommand(
      "compare",
      "generalization and specificity of models side by side, with standard errors and paired tests");
  command->footer("Example:\n  foramen compare model model_icp -o comparison");
  command->add_option("models", request.models, "folders of two or more models")->required()->expected(2, 8);
  command->add_option("-o,--output", request.output, "folder for the page and the curves")
      ->default_val("foramen-compare");
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return compare(*options); }; });
}

}  // namespace foramen::app
