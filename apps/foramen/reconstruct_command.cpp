#include "command.hpp"
#include "workflow/reconstruct_shapes.hpp"

namespace foramen::app {
namespace {

struct ReconstructCommand {
  ReconstructRequest request;
  Console console;
};

int reconstruct(const ReconstructCommand& command) {
  const int files = reconstruct_shapes(command.request, command.console.context());
  tell_written(command.console, command.request.output, files);
  return ExitCode::done;
}

}  // namespace

void add_reconstruct(CLI::App& program, Run& run) {
  auto options = std::make_shared<ReconstructCommand>();
  ReconstructRequest& request = options->request;
  CLI::App* command = program.add_subcommand("reconstruct", "shapes of given scores, in model coordinates");
  command->footer("Example:\n  foramen reconstruct model model/scores.csv -o shapes");
  command->add_option("model", request.model, "folder of a model, or its model.h5")->required();
  command
      ->add_option("scores", request.scores,
                   "CSV file with the columns shape, mode1, mode2 ... (standard deviations; a mode without a "
                   "column is 0)")
      ->required();
  command->add_option("-o,--output", request.output, "folder to write, a mesh a row")->required();
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return reconstruct(*options); }; });
}

}  // namespace foramen::app
