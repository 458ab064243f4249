#include <iostream>

#include "command.hpp"
#include "foramen/core/error.hpp"
#include "repair_options.hpp"
#include "workflow/repair_file.hpp"

namespace foramen::app {
namespace {

struct RepairCommand {
  RepairRequest request;
  Console console;
};

int repair(const RepairCommand& command) {
  const Console& console = command.console;
  const RepairSummary summary = repair_file(command.request, console.context().without_progress());
  for (const Message& note : summary.notes) console.warn(note);
  if (summary.refusal) throw InvalidInput(*summary.refusal);
  if (console.json) std::cout << summary.json << '\n';
  for (const std::string& line : summary.lines) console.say(line);
  return ExitCode::done;
}

}  // namespace

void add_repair(CLI::App& program, Run& run) {
  auto options = std::make_shared<RepairCommand>();
  RepairRequest& request = options->request;
  CLI::App* command = program.add_subcommand("repair",
                                             "makes a surface one closed, manifold, outward surface of genus "
                                             "1; lists what was changed: duplicate vertices "
                                             "and triangles, triangles without area, non-manifold edges and "
                                             "vertices, small holes, stray pieces, inner "
                                             "shells, orientation, self-intersections, noise handles");
  command->footer("Example:\n  foramen repair raw.stl -o L3.ply");
  command->add_option("input", request.input, "mesh file")->required();
  command->add_option("-o,--output", request.output, "file to write, .ply or .vtp")->required();
  add_unit_option(*command, request.unit);
  add_repair_options(*command, request.options);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return repair(*options); }; });
}

}  // namespace foramen::app
