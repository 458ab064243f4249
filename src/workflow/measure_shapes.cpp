#include "workflow/measure_shapes.hpp"

#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/read_cohort.hpp"

namespace foramen {
namespace {

// The measures of a corresponding mesh in mm.
ShapeMeasures measured(const Measurer& measurer, const std::filesystem::path& file, LengthUnit unit) {
  TriangleSoup soup = read_mesh(file).soup;
  for (Vec3& p : soup.points) p *= millimetres_per(unit);
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

std::vector<MeasuredShape> measure_files(const Measurer& measurer,
                                         const std::vector<std::filesystem::path>& inputs, LengthUnit unit,
                                         const RunContext& ctx) {
  const auto files = find_meshes(inputs).files;
  std::vector<MeasuredShape> all;
  for (const auto& file : files) {
    ctx.step("measure", static_cast<double>(all.size()) / static_cast<double>(files.size()));
    all.push_back({file.name, measured(measurer, file.path, unit)});
  }
  return all;
}

}  // namespace foramen
