#include <filesystem>
#include <iostream>

#include "command.hpp"
#include "described_option.hpp"
#include "repair_options.hpp"
#include "workflow/evaluate_folder.hpp"

namespace foramen::app {
namespace {

struct EvaluateCommand {
  EvaluateFolderRequest request;
  Console console;
};

int evaluate(const EvaluateCommand& command) {
  const EvaluatedFolder result = evaluate_folder(command.request, command.console.context());
  for (const Message& note : result.notes) command.console.warn(note);
  if (command.console.json)
    std::cout << result.json << '\n';
  else
    command.console.say(result.text);
  return ExitCode::done;
}

}  // namespace

void add_evaluate(CLI::App& program, Run& run) {
  auto options = std::make_shared<EvaluateCommand>();
  EvaluateFolderRequest& request = options->request;
  CLI::App* command = program.add_subcommand("evaluate",
                                             "compactness, generalization, specificity of any folder of "
                                             "corresponding meshes, ours or another tool's");
  command->footer("Example:\n  foramen evaluate other_tool/ --shapes shapes/ -o evaluation");
  command
      ->add_option("corresponding", request.corresponding,
                   "folder of meshes with identical triangles (or a model's folder)")
      ->required();
  command->add_option("--shapes", request.shapes,
                      "folder of the original surfaces, by the same names; without it distances are to the "
                      "corresponding meshes");
  command->add_option("--truth", request.truth, "folder of the true correspondence, by the same names");
  command->add_option("--true-landmarks", request.true_landmarks,
                      "folder to write the same landmarks in true correspondence to (needs --truth)");
  command->add_option("--marks", request.marks,
                      "points and curves that people marked on the surfaces, files or folders: .mrk.json or "
                      ".fcsv of Slicer, .json of Scalismo, or .csv");
  command->add_option("--regions", request.regions,
                      "regions that people marked, files or folders: a label for each vertex of the surfaces "
                      "in .txt, .ply, .vtk or .vtp, or a label map");
  command->add_option("-o,--output", request.output, "folder for metrics.json and metrics.csv");
  add_unit_option(*command, request.unit);
  add_described(*command, "--samples", request.options, "draws");
  add_described(*command, "--seed", request.options, "seed");
  command->add_option("--subject-regex", request.subject_pattern,
                      "the part of a file name that names its subject");
  add_described(*command, "--scale", request.options, "scale");
  add_described(*command, "--weights", request.options, "landmark_weights");
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return evaluate(*options); }; });
}

}  // namespace foramen::app
