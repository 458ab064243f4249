#include "workflow/measure_model.hpp"

#include <utility>

#include "io/table_file.hpp"
#include "modelfiles/measures_file.hpp"
#include "modelfiles/model_folder.hpp"
#include "workflow/measure_shapes.hpp"

namespace foramen {
namespace {

std::vector<std::string> header_of(const MeasureDefinitions& definitions) {
  std::vector<std::string> header{"shape"};
  for (const NamedPoint& point : definitions.points)
    for (const char* axis : {"_x_mm", "_y_mm", "_z_mm"}) header.push_back(point.name + axis);
  for (const NamedDistance& distance : definitions.distances) header.push_back(distance.name + "_mm");
  for (const NamedRegion& region : definitions.regions) header.push_back(region.name + "_mm2");
  return header;
}

Row row_of(const MeasuredShape& shape) {
  Row row{shape.name};
  for (const Vec3& p : shape.measures.points)
    for (const double x : p) row.emplace_back(x);
  for (const double d : shape.measures.distances) row.emplace_back(d);
  for (const double a : shape.measures.areas) row.emplace_back(a);
  return row;
}

}  // namespace

MeasureSummary measure_model(const MeasureRequest& request, const RunContext& ctx) {
  const LoadedModel loaded = load_model(request.model);
  const MeasureDefinitions definitions = read_measures(request.definitions);
  const Measurer measurer = measurer_of(loaded.model, definitions, request.definitions.string());
  std::vector<std::filesystem::path> inputs = request.meshes;
  if (inputs.empty()) inputs = {request.model / "corresponding"};
  std::vector<Row> rows;
  MeasuredFiles measured = measure_files(measurer, inputs, request.unit, ctx);
  for (const MeasuredShape& shape : measured.shapes) rows.push_back(row_of(shape));
  const std::vector<std::string> header = header_of(definitions);
  write_csv(request.output, header, rows);
  return {rows.size(), header, std::move(measured.notes)};
}

}  // namespace foramen
