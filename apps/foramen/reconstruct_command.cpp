#include <cmath>
#include <filesystem>
#include <iostream>
#include <set>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "io/table_file.hpp"
#include "modelfiles/model_folder.hpp"

namespace foramen::app {
namespace {

namespace fs = std::filesystem;

struct ReconstructCommand {
  std::string model, scores, output;
  Console console;
};

struct NamedScores {
  std::string name;
  Eigen::VectorXd scores;  // scores of all modes, in standard deviations
};

// The index of the mode, counted from 0, of a column such as "mode3".
int mode_of(const std::string& column, int modes, const std::string& file) {
  for (int m = 0; m < modes; ++m)
    if (column == "mode" + std::to_string(m + 1)) return m;
  throw IoError(file + ": the column \"" + column + "\" is no mode of this model; it has mode1 to mode" +
                std::to_string(modes));
}

// Reads one shape per row. The scores of modes without a column are 0.
std::vector<NamedScores> read_scores(const std::string& file, int modes) {
  const Table table = read_csv(file);
  if (table.header.front() != "shape")
    throw IoError(file + ": its first column is \"" + table.header.front() +
                  "\"; it must be \"shape\", and the others mode1, mode2 ..., as in a model's scores.csv");
  std::vector<int> mode;
  for (std::size_t c = 1; c < table.header.size(); ++c) mode.push_back(mode_of(table.header[c], modes, file));
  std::vector<NamedScores> all;
  std::set<std::string> names;
  for (const auto& row : table.rows) {
    NamedScores one{row[0], Eigen::VectorXd::Zero(modes)};
    if (one.name.empty() || fs::path(one.name).filename() != one.name || !names.insert(one.name).second)
      throw IoError(file + ": the shape \"" + one.name +
                    "\" has no name for a file of its own; every row needs another, without /");
    for (std::size_t c = 0; c < mode.size(); ++c) {
      const double score = parse_number(row[c + 1]);
      if (!std::isfinite(score))
        throw IoError(file + ": the shape \"" + one.name + "\" has a score that is not finite; correct it");
      one.scores[mode[c]] = score;
    }
    all.push_back(std::move(one));
  }
  return all;
}

int reconstruct(const ReconstructCommand& command) {
  const LoadedModel loaded = load_model(command.model);
  const std::vector<NamedScores> all = read_scores(command.scores, loaded.model.modes());
  const RunContext ctx = command.console.context();
  fs::create_directories(command.output);
  for (const NamedScores& one : all) {
    ctx.check();
    const Eigen::VectorXd shape =
        loaded.model.reconstruct(one.scores.cwiseProduct(loaded.model.variance().cwiseSqrt()));
    write_ply(fs::path(command.output) / (one.name + ".ply"), {unflattened(shape), loaded.model.triangles()},
              loaded.space);
  }
  if (command.console.json)
    std::cout << nlohmann::ordered_json{{"folder", command.output}, {"files", all.size()}}.dump(2) << '\n';
  else
    command.console.say("wrote " + std::to_string(all.size()) + " meshes to " + command.output);
  return ExitCode::done;
}

}  // namespace

void add_reconstruct(CLI::App& program, Run& run) {
  auto options = std::make_shared<ReconstructCommand>();
  CLI::App* command = program.add_subcommand("reconstruct", "shapes of given scores, in model coordinates");
  command->footer("Example:\n  foramen reconstruct model model/scores.csv -o shapes");
  command->add_option("model", options->model, "folder of a model, or its model.h5")->required();
  command
      ->add_option("scores", options->scores,
                   "CSV file with the columns shape, mode1, mode2 ... (standard deviations; a mode without a "
                   "column is 0)")
      ->required();
  command->add_option("-o,--output", options->output, "folder to write, a mesh a row")->required();
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return reconstruct(*options); }; });
}

}  // namespace foramen::app
