#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "repair_options.hpp"
#include "workflow/measure_model.hpp"

namespace foramen::app {
namespace {

struct MeasureCommand {
  MeasureRequest request;
  Console console;
};

int measure(const MeasureCommand& command) {
  const std::string file = command.request.output.string();
  const MeasureSummary summary = measure_model(command.request, command.console.context());
  for (const Message& note : summary.notes) command.console.warn(note);
  if (command.console.json)
    std::cout << nlohmann::ordered_json{{"file", file},
                                        {"shapes", summary.shapes},
                                        {"columns", summary.columns}}
                     .dump(2)
              << '\n';
  else
    command.console.say(file + ": " + std::to_string(summary.columns.size() - 1) + " columns of " +
                        std::to_string(summary.shapes) + " shapes");
  return ExitCode::done;
}

}  // namespace

void add_measure(CLI::App& program, Run& run) {
  auto options = std::make_shared<MeasureCommand>();
  MeasureRequest& request = options->request;
  CLI::App* command = program.add_subcommand(
      "measure",
      "points, distances and areas that a JSON file defines once on the mean, taken on all shapes of a model "
      "or on any meshes with its landmarks, as CSV");
  command->footer("Example:\n  foramen measure model measures.json -o measures.csv");
  command->add_option("model", request.model, "folder of a model")->required();
  command
      ->add_option("definitions", request.definitions,
                   "JSON: {\"points\": {\"tip\": [x, y, z] on the mean in mm, \"front\": landmark}, "
                   "\"distances\": {\"length\": [\"tip\", \"front\"]}, \"regions\": {\"facet\": {\"centre\": "
                   "\"tip\", \"radius_mm\": 6}, \"rim\": {\"landmarks\": [3, 4, 5]}}}")
      ->required();
  command->add_option("meshes", request.meshes,
                      "mesh files in correspondence, or folders of them (default: the model's own shapes)");
  command->add_option("-o,--output", request.output, "CSV file to write")->required();
  add_unit_option(*command, request.unit);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return measure(*options); }; });
}

}  // namespace foramen::app
