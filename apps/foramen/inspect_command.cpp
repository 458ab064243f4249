#include <iostream>

#include <nlohmann/json.hpp>

#include "command.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/core/units.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/repair/remove_handles.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "modelfiles/mesh_report_json.hpp"
#include "modelfiles/repair_record.hpp"
#include "remedy_words.hpp"
#include "repair_options.hpp"

namespace foramen::app {
namespace {

using nlohmann::ordered_json;

// The handles of a surface that has more than the canal; unset if they cannot be determined.
std::optional<SurfaceHandles> handles_of(const TriangleSoup& soup, const MeshReport& r,
                                         const Console& console) {
  if (r.genus.value_or(0) < 2 || *r.genus > RemoveHandlesOptions().most_handles || !is_in_millimetres(r) ||
      r.duplicate_triangles + r.unused_vertices + r.invalid_triangles + r.non_finite_vertices > 0)
    return std::nullopt;
  const Mesh mesh = build_mesh(soup);
  try {
    return find_handles(r.inward ? reversed(mesh) : mesh, console.context().without_progress());
  } catch (const ConvergenceError&) {
    return std::nullopt;  // the surface intersects itself at a handle
  }
}

ordered_json as_json(const SurfaceHandles& handles) {
  ordered_json extra = ordered_json::array();
  for (const Handle& h : handles.extra) {
    extra.push_back(handle_json(h));
    extra.back()["noise"] = is_noise(h, {});
  }
  return {{"extra", extra}, {"canal", handle_json(handles.canal)}};
}

void print(const SurfaceHandles& handles) {
  for (const Handle& h : handles.extra)
    std::cout << "  beside the canal: " << description(h)
              << (is_noise(h, {}) ? ": noise, which `foramen repair` removes" : ": too large for noise")
              << '\n';
  std::cout << "  the canal: " << description(handles.canal) << '\n';
}

ordered_json as_json(const std::string& file, const MeshReport& r,
                     const std::optional<AnatomicalSpace>& space) {
  ordered_json out = {{"file", file}};
  out.update(mesh_report_json(r));
  if (space) out["space"] = *space == AnatomicalSpace::lps ? "LPS" : "RAS";
  return out;
}

std::string yes_no(bool value) { return value ? "yes" : "no"; }

// What the size says of the unit. Lengths are in mm if the unit is certain or is another than mm.
std::string unit_text(const MeshReport& r, const InputUnit& unit) {
  if (is_in_millimetres(r)) return "mm";
  if (unit.certain) return "mm; the size of no vertebra";
  if (unit.length != LengthUnit::millimetre)
    return "mm; the size of no vertebra: the file is not in " + std::string(name(unit.length));
  if (const auto likely = likely_unit(r.box.diagonal()))
    return "not mm; probably " + std::string(name(*likely));
  return "the size of no vertebra in mm, cm, m or um";
}

void print(const std::string& file, const MeshReport& r, const InputUnit& unit) {
  std::cout << file << '\n'
            << "  vertices " << r.vertices << ", triangles " << r.triangles << ", edges " << r.edges
            << ", components " << r.components << '\n'
            << "  closed " << yes_no(r.closed()) << ", manifold " << yes_no(r.manifold()) << ", oriented "
            << yes_no(r.oriented()) << (r.inward ? " (inward)" : "") << ", Euler number " << r.euler_number
            << ", genus " << (r.genus ? std::to_string(*r.genus) : std::string("undefined")) << '\n'
            << "  degenerate triangles " << r.degenerate_triangles << ", duplicate triangles "
            << r.duplicate_triangles << ", duplicate vertices " << r.duplicate_vertices << '\n';
  const Vec3 size = r.box.high - r.box.low;
  std::cout << "  size " << size.x() << " x " << size.y() << " x " << size.z() << " (" << unit_text(r, unit)
            << "), area " << r.area << ", volume " << r.volume << '\n';
  if (const auto obstacle = obstacle_to_model(r))
    std::cout << "  NOT USABLE: " << worded(obstacle->message()) << '\n';
  else
    std::cout << "  usable" << (r.inward ? " (its inward winding will be reversed)" : "") << '\n';
}

struct InspectOptions {
  std::vector<std::string> files;
  InputUnit unit;
  Console console;
};

int inspect(const InspectOptions& options) {
  ordered_json all = ordered_json::array();
  bool refused_any = false;
  for (const std::string& file : options.files) {
    try {
      MeshFile read = read_mesh(file);
      for (Vec3& p : read.soup.points) p *= millimetres_per(options.unit.length);
      const MeshReport report = inspect_mesh(read.soup);
      std::optional<SurfaceHandles> handles;
      if (options.console.json || !options.console.quiet)
        handles = handles_of(read.soup, report, options.console);
      if (options.console.json) {
        all.push_back(as_json(file, report, read.space));
        if (!read.notes.empty()) all.back()["notes"] = texts_of(read.notes);
        if (handles) all.back()["handles"] = as_json(*handles);
      } else if (!options.console.quiet) {
        print(file, report, options.unit);
        for (const Message& note : read.notes) std::cout << "  note: " << worded(note) << '\n';
        if (handles) print(*handles);
      }
      refused_any |= obstacle_to_model(report).has_value();
    } catch (const Error& e) {
      refused_any = true;
      if (options.console.json)
        all.push_back({{"file", file}, {"usable", false}, {"finding", e.what()}});
      else
        std::cerr << "foramen: " << worded(e) << '\n';
    }
  }
  if (options.console.json) std::cout << ordered_json{{"files", all}}.dump(2) << '\n';
  return refused_any ? ExitCode::refused : ExitCode::done;
}

}  // namespace

void add_inspect(CLI::App& program, Run& run) {
  auto options = std::make_shared<InspectOptions>();
  CLI::App* command =
      program.add_subcommand("inspect", "topology and quality audit of surfaces, one verdict a file");
  command->footer("Example:\n  foramen inspect shapes/*.ply");
  command->add_option("files", options->files, "mesh files")->required();
  add_unit_option(*command, options->unit);
  add_console_options(*command, options->console);
  command->callback([options, &run] { run = [options] { return inspect(*options); }; });
}

}  // namespace foramen::app
