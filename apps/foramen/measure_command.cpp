#include <filesystem>
#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "io/table_file.hpp"
#include "modelfiles/measures_file.hpp"
#include "modelfiles/model_folder.hpp"
#include "repair_options.hpp"
#include "workflow/measure_shapes.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;

struct MeasureCommand {
  std::string model, definitions, output;
  std::vector<std::string> meshes;  // empty: the training shapes of the model
  LengthUnit unit = LengthUnit::millimetre;
  Console console;
};

std::vector<std::string> header_of(const MeasureDefinitions& definitions) {
  std::vector<std::string> header{"shape"};
  for (const NamedPoint& point : definitions.points)
    for (const char* axis : {"_x_mm", "_y_mm", "_z_mm"}) header.push_back(point.name + axis);
  for (const NamedDistance& distance : definitions.distances) header.push_back(distance.name + "_mm");
  for (const NamedRegion& region : definitions.regions) header.push_back(region.name + "_mm2");
  return header;
}

Row row_of(const MeasuredShape& shape) {
  Row row{shape.name};
  for (const Vec3& p : shape.measures.points)
    for (const double x : p) row.emplace_back(x);
  for (const double d : shape.measures.distances) row.emplace_back(d);
  for (const double a : shape.measures.areas) row.emplace_back(a);
  return row;
}

int measure(const MeasureCommand& command) {
  const LoadedModel loaded = load_model(command.model);
  const MeasureDefinitions definitions = read_measures(command.definitions);
  const Measurer measurer = measurer_of(loaded.model, definitions, command.definitions);
  std::vector<fs::path> inputs(command.meshes.begin(), command.meshes.end());
  if (inputs.empty()) inputs = {fs::path(command.model) / "corresponding"};
  const std::vector<std::string> header = header_of(definitions);
  std::vector<Row> rows;
  for (const MeasuredShape& shape : measure_files(measurer, inputs, command.unit, command.console.context()))
    rows.push_back(row_of(shape));
  write_csv(command.output, header, rows);
  if (command.console.json)
    std::cout << nlohmann::ordered_json{{"file", command.output},
                                        {"shapes", rows.size()},
                                        {"columns", header}}
                     .dump(2)
              << '\n';
  else
    command.console.say(command.output + ": " + std::to_string(header.size() - 1) + " columns of " +
                        std::to_string(rows.size()) + " shapes");
  return ExitCode::done;
}

}  // namespace

void add_measure(CLI::App& program, Run& run) {
  auto options = std::make_shared<MeasureCommand>();
  CLI::App* command = program.add_subcommand(
      "measure",
      "points, distances and areas that a JSON file defines once on the mean, taken on all shapes of a model "
      "or on any meshes with its landmarks, as CSV");
  command->footer("Example:\n  foramen measure model measures.json -o measures.csv");
  command->add_option("model", options->model, "folder of a model")->required();
  command
      ->add_option("definitions", options->definitions,
                   "JSON: {\"points\": {\"tip\": [x, y, z] on the mean in mm, \"front\": landmark}, "
                   "\"distances\": {\"length\": [\"tip\", \"front\"]}, \"regions\": {\"facet\": {\"centre\": "
                   "\"tip\", \"radius_mm\": 6}, \"rim\": {\"landmarks\": [3, 4, 5]}}}")
      ->required();
  command->add_option("meshes", options->meshes,
                      "mesh files in correspondence, or folders of them (default: the model's own shapes)");
  command->add_option("-o,--output", options->output, "CSV file to write")->required();
  add_unit_option(*command, options->unit);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return measure(*options); }; });
}

}  // namespace foramen::app
