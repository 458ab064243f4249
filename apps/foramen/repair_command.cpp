#include <algorithm>
#include <cctype>
#include <filesystem>
#include <functional>
#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/read_cohort.hpp"
#include "modelfiles/repair_record.hpp"
#include "repair_options.hpp"

namespace foramen::app {
namespace {

using nlohmann::ordered_json;

struct RepairCommand {
  std::string input, output;
  InputUnit unit;
  RepairOptions repair;
  Console console;
};

using Writer = std::function<void(const std::filesystem::path&, const TriangleSoup&, AnatomicalSpace)>;

Writer writer_for(const std::string& output) {
  std::string extension = std::filesystem::path(output).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".ply")
    return [](const auto& path, const auto& soup, auto space) { write_ply(path, soup, space); };
  if (extension == ".vtp") return write_vtp;
  throw InvalidInput(output + ": a repaired surface is written as .ply or .vtp; give such a name with -o");
}

ordered_json as_json(const RepairCommand& command, const RepairedMesh& repaired) {
  ordered_json out = {{"input", command.input}, {"output", command.output}};
  out.update(repair_json(repaired.report));
  out["vertices"] = repaired.mesh.vertex_count();
  out["triangles"] = repaired.mesh.face_count();
  ordered_json origin = ordered_json::array();
  for (VertexId raw : repaired.origin) origin.push_back(raw.index);
  out["origin"] = std::move(origin);
  return out;
}

void print(const RepairCommand& command, const RepairedMesh& repaired) {
  const Console& console = command.console;
  const RepairReport& report = repaired.report;
  console.say(command.input + ": " + summary(report));
  console.say("the canal: " + description(report.canal));
  if (report.largest_move_mm > 0)
    console.say("no vertex that was kept moved by more than " + std::to_string(report.largest_move_mm) +
                " mm");
  console.say("wrote " + command.output + ": " + std::to_string(repaired.mesh.vertex_count()) +
              " vertices, " + std::to_string(repaired.mesh.face_count()) + " triangles, genus 1");
}

int repair(const RepairCommand& command) {
  const Writer write = writer_for(command.output);
  MeshFile file = read_mesh(command.input);
  for (const Message& note : file.notes) command.console.warn(note.about(command.input));
  const RepairedMesh repaired = [&] {
    try {
      return repair_surface(std::move(file.soup), command.unit, command.repair,
                            command.console.context().without_progress());
    } catch (const InvalidInput& e) {
      throw InvalidInput(message_of(e).about(command.input));
    }
  }();
  TriangleSoup soup = repaired.mesh.soup();
  for (Vec3& p : soup.points) p /= millimetres_per(command.unit.length);
  write(command.output, soup, file.space.value_or(AnatomicalSpace::lps));
  if (command.console.json)
    std::cout << as_json(command, repaired).dump(2) << '\n';
  else
    print(command, repaired);
  if (const auto note = size_note(repaired.mesh, command.unit))
    command.console.warn(note->about(command.input));
  if (const auto& meeting = repaired.report.remaining_self_intersections; !meeting.empty())
    command.console.warn(std::to_string(meeting.size()) +
                         " pairs of triangles meet still; mend the segmentation there");
  return ExitCode::done;
}

}  // namespace

void add_repair(CLI::App& program, Run& run) {
  auto options = std::make_shared<RepairCommand>();
  CLI::App* command = program.add_subcommand("repair",
                                             "makes a surface one closed, manifold, outward surface of genus "
                                             "1; lists what was changed: duplicate vertices "
                                             "and triangles, triangles without area, non-manifold edges and "
                                             "vertices, small holes, stray pieces, inner "
                                             "shells, orientation, self-intersections, noise handles");
  command->footer("Example:\n  foramen repair raw.stl -o L3.ply");
  command->add_option("input", options->input, "mesh file")->required();
  command->add_option("-o,--output", options->output, "file to write, .ply or .vtp")->required();
  add_unit_option(*command, options->unit);
  add_repair_options(*command, options->repair);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return repair(*options); }; });
}

}  // namespace foramen::app
