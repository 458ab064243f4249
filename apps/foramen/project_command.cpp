#include <iostream>

#include "command.hpp"
#include "repair_options.hpp"
#include "workflow/project_files.hpp"

namespace foramen::app {
namespace {

struct ProjectCommand {
  ProjectRequest request;
  Console console;
};

int project(const ProjectCommand& command) {
  const Console& console = command.console;
  const ProjectSummary summary = project_files(command.request, console.context());
  for (const Message& note : summary.notes) console.warn(note);
  bool failed = false;
  for (const ProjectSummary::Line& line : summary.lines) {
    failed |= line.failed;
    if (line.failed)
      console.warn(line.message);
    else
      console.say(line.message.text);
  }
  if (console.json) std::cout << summary.json << '\n';
  return failed ? ExitCode::refused : ExitCode::done;
}

}  // namespace

void add_project(CLI::App& program, Run& run) {
  auto options = std::make_shared<ProjectCommand>();
  ProjectRequest& request = options->request;
  CLI::App* command = program.add_subcommand(
      "project",
      "what a model says of new surfaces, closed and in any pose: registers each to the mean, gives its "
      "landmarks, scores, the model's closest shape and how far it is, everywhere");
  command->footer("Example:\n  foramen project model new/L2.ply -o projected");
  command->add_option("model", request.model, "folder of a model")->required();
  command->add_option("surfaces", request.surfaces, "mesh files, or folders of them")->required();
  command->add_option("-o,--output", request.output, "folder to write")->required();
  command
      ->add_option("--leave-out", request.leave_out,
                   "training shapes to leave out of the model for a second distance, comma-separated "
                   "(default: the one of the surface's own name)")
      ->delimiter(',')
      ->allow_extra_args(false);
  add_unit_option(*command, request.unit);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return project(*options); }; });
}

}  // namespace foramen::app
