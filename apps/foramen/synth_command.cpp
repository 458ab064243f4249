#include <cstdio>
#include <filesystem>

#include "command.hpp"
#include "described_option.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/synth/synth_cohort.hpp"
#include "io/atomic_file.hpp"
#include "shape_options.hpp"

namespace foramen::app {
namespace {

struct SynthCommand {
  SynthOptions synth;
  std::string output;
  Console console;
};

int synth(const SynthCommand& command) {
  const auto shapes = synth_cohort(command.synth, command.console.context());
  write_synth_cohort(shapes, command.output);
  command.console.say("wrote " + std::to_string(shapes.size()) + " shapes to " + command.output +
                      "/shapes and their true correspondence to " + command.output + "/truth");
  return ExitCode::done;
}

}  // namespace

void add_synth_options(CLI::App& command, SynthOptions& options) {
  add_described(command, "-n,--shapes", options, "shapes");
  add_described(command, "--seed", options, "seed");
  add_described(command, "--deformation", options, "deformation");
  add_described(command, "--modes", options, "modes");
  add_described(command, "--amplitude", options, "amplitude");
  add_described(command, "--correlation", options, "correlation");
  add_described(command, "--vertices", options, "vertices");
}

std::string synth_name(int index) {
  char name[32];
  std::snprintf(name, sizeof name, "synth%03d", index + 1);
  return name;
}

void write_synth_cohort(const std::vector<SynthShape>& shapes, const std::filesystem::path& folder) {
  make_folder(folder / "shapes");
  make_folder(folder / "truth");
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const std::string file = synth_name(static_cast<int>(i)) + ".ply";
    write_ply(folder / "shapes" / file, shapes[i].surface);
    write_ply(folder / "truth" / file, shapes[i].truth);
  }
}

void add_synth(CLI::App& program, Run& run) {
  auto options = std::make_shared<SynthCommand>();
  CLI::App* command = program.add_subcommand("synth", "vertebra-like shapes with known correspondence");
  command->footer("Example:\n  foramen synth -n 14 --seed 1 -o cohort");
  add_synth_options(*command, options->synth);
  command->add_option("-o,--output", options->output, "folder to write")->required();
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return synth(*options); }; });
}

}  // namespace foramen::app
