#include "workflow/measure_shapes.hpp"

#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/read_cohort.hpp"
#include "inputs/surface_size.hpp"

namespace foramen {
namespace {

// The measures of a corresponding mesh in mm.
ShapeMeasures measured(const Measurer& measurer, TriangleSoup soup, const std::filesystem::path& file) {
  try {
    return measurer(build_mesh(std::move(soup)));
  } catch (const InvalidInput& e) {
    throw InvalidInput(message_of(e).about(file.string()));
  }
}

}  // namespace

Measurer measurer_of(const ShapeModel& model, const MeasureDefinitions& definitions,
                     const std::string& source) {
  const Mesh mean = build_mesh({unflattened(model.mean()), model.triangles()});
  try {
    return {mean, definitions};
  } catch (const InvalidInput& e) {
    throw InvalidInput(message_of(e).about(source));
  }
}

MeasuredFiles measure_files(const Measurer& measurer, const std::vector<std::filesystem::path>& inputs,
                            const InputUnit& unit, const RunContext& ctx) {
  const FoundFiles found = find_meshes(inputs);
  MeasuredFiles all;
  all.notes = found.notes;
  SizeCheck sizes(unit);
  for (const ShapeFile& file : found.files) {
    ctx.step("measure", static_cast<double>(all.shapes.size()) / static_cast<double>(found.files.size()));
    auto [soup, space, file_notes] = read_mesh(file.path);
    for (const Message& note : file_notes) all.notes.push_back(note.about(file.shown()));
    for (Vec3& p : soup.points) p *= millimetres_per(unit.length);
    sizes.add(file.path.string(), soup.points);
    all.shapes.push_back({file.name, measured(measurer, std::move(soup), file.path)});
  }
  if (const auto note = sizes.note()) all.notes.push_back(*note);
  return all;
}

}  // namespace foramen
