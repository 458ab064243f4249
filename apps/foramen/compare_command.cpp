#include <filesystem>
#include <iostream>

#include "command.hpp"
#include "findings/compare_models.hpp"
#include "io/atomic_file.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;

struct CompareCommand {
  std::vector<std::string> models;
  std::string output;
  Console console;
};

int compare(const CompareCommand& command) {
  const std::vector<fs::path> models(command.models.begin(), command.models.end());
  const ModelComparison comparison = compare_models(models);
  if (command.console.json)
    std::cout << comparison.json << '\n';
  else
    command.console.say(comparison.text);
  const fs::path folder = command.output;
  make_folder(folder);
  write_file(folder / "compare.html", comparison.html);
  write_file(folder / "compare.json", comparison.json + "\n");
  for (const auto& [name, svg] : comparison.charts) write_file(folder / name, svg);
  command.console.say("wrote " + (folder / "compare.html").string());
  return ExitCode::done;
}

}  // namespace

void add_compare(CLI::App& program, Run& run) {
  auto options = std::make_shared<CompareCommand>();
  CLI::App* command = program.add_subcommand(
      "compare",
      "generalization and specificity of models side by side, with standard errors and paired tests");
  command->footer("Example:\n  foramen compare model model_icp -o comparison");
  command->add_option("models", options->models, "folders of two or more models")->required()->expected(2, 8);
  command->add_option("-o,--output", options->output, "folder for the page and the curves")
      ->default_val("foramen-compare");
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return compare(*options); }; });
}

}  // namespace foramen::app
