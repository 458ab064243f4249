#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "foramen/repair/handles.hpp"
#include "remedy_words.hpp"
#include "repair_options.hpp"
#include "workflow/inspect_file.hpp"

namespace foramen::app {
namespace {

struct InspectCommand {
  std::vector<std::string> files;
  InputUnit unit;
  Console console;
};

std::string yes_no(bool value) { return value ? "yes" : "no"; }

void print(const MeshReport& r, const std::string& size_unit) {
  std::cout << "  vertices " << r.vertices << ", triangles " << r.triangles << ", edges " << r.edges
            << ", components " << r.components << '\n'
            << "  closed " << yes_no(r.closed()) << ", manifold " << yes_no(r.manifold()) << ", oriented "
            << yes_no(r.oriented()) << (r.inward ? " (inward)" : "") << ", Euler number " << r.euler_number
            << ", genus " << (r.genus ? std::to_string(*r.genus) : std::string("undefined")) << '\n'
            << "  degenerate triangles " << r.degenerate_triangles << ", duplicate triangles "
            << r.duplicate_triangles << ", duplicate vertices " << r.duplicate_vertices << '\n';
  const Vec3 size = r.box.high - r.box.low;
  std::cout << "  size " << size.x() << " x " << size.y() << " x " << size.z() << " (" << size_unit
            << "), area " << r.area << ", volume " << r.volume << '\n';
  if (const auto obstacle = obstacle_to_model(r))
    std::cout << "  NOT USABLE: " << worded(obstacle->message()) << '\n';
  else
    std::cout << "  usable" << (r.inward ? " (its inward winding will be reversed)" : "") << '\n';
}

void print(const SurfaceHandles& handles) {
  for (const Handle& h : handles.extra)
    std::cout << "  beside the canal: " << description(h)
              << (is_noise(h, {}) ? ": noise, which `foramen repair` removes" : ": too large for noise")
              << '\n';
  std::cout << "  the canal: " << description(handles.canal) << '\n';
}

void print(const InspectedFile& inspected) {
  std::cout << inspected.file.string() << '\n';
  print(inspected.report, inspected.size_unit);
  for (const Message& note : inspected.notes) std::cout << "  note: " << worded(note) << '\n';
  if (inspected.handles) print(*inspected.handles);
}

int inspect(const InspectCommand& command) {
  const Console& console = command.console;
  const RunContext ctx = console.context().without_progress();
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  bool refused_any = false;
  for (const std::string& file : command.files) {
    const InspectedFile inspected = inspect_file(
        {.file = file, .unit = command.unit, .find_handles = console.json || !console.quiet}, ctx);
    refused_any |= !inspected.usable();
    if (console.json)
      all.push_back(inspection_json(inspected));
    else if (inspected.error)
      std::cerr << "foramen: " << worded(*inspected.error) << '\n';
    else if (!console.quiet)
      print(inspected);
  }
  if (console.json) std::cout << nlohmann::ordered_json{{"files", all}}.dump(2) << '\n';
  return refused_any ? ExitCode::refused : ExitCode::done;
}

}  // namespace

void add_inspect(CLI::App& program, Run& run) {
  auto options = std::make_shared<InspectCommand>();
  CLI::App* command =
      program.add_subcommand("inspect", "topology and quality audit of surfaces, one verdict a file");
  command->footer("Example:\n  foramen inspect shapes/*.ply");
  command->add_option("files", options->files, "mesh files")->required();
  add_unit_option(*command, options->unit);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return inspect(*options); }; });
}

}  // namespace foramen::app
