#include "modelfiles/model_record.hpp"

#include <algorithm>
#include <utility>

#include "foramen/core/error.hpp"
#include "modelfiles/atlas_file.hpp"
#include "modelfiles/error_maps_file.hpp"
#include "modelfiles/metrics_file.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

void require_one_model(const fs::path& folder, const ModelRecord& record) {
  const std::size_t shapes = record.evaluation.names.size();
  const auto used = std::count_if(record.run.shapes.begin(), record.run.shapes.end(),
                                  [](const RunShape& shape) { return shape.used.has_value(); });
  const bool fits = used == std::ssize(record.evaluation.names) && record.loaded.names.size() == shapes &&
                    record.evaluation.representation.shapes.size() == shapes &&
                    record.loaded.scores.cols() == static_cast<Eigen::Index>(shapes) &&
                    record.evaluation.landmarks == record.loaded.model.landmarks() &&
                    std::ssize(record.atlas.landmarks.turns) == record.loaded.model.landmarks() &&
                    record.atlas.landmarks.triangles == record.loaded.model.triangles();
  if (!fits)
    throw IoError(folder.string() +
                  ": its files are not of one model (shapes or landmarks differ); build it again");
}

void require_marks_on_model(const fs::path& folder, const ModelRecord& record) {
  if (!record.evaluation.marks) return;
  const auto triangles = std::ssize(record.loaded.model.triangles());
  for (const PlacedMark& mark : record.evaluation.marks->placed)
    for (const SurfacePoint& place : mark.places)
      if (place.face.index >= triangles)
        throw IoError((folder / "metrics.json").string() + ": the mark '" + mark.mark + "' is on triangle " +
                          std::to_string(place.face.index) + ", but the model has " +
                          std::to_string(triangles) + "; an evaluation of the model writes it anew",
                      {{RemedyKind::evaluate_model}});
}

}  // namespace

ModelRecord read_model_record(const fs::path& folder) {
  ModelRecord record{.run = read_run(folder),
                     .evaluation = read_metrics_of_shapes(folder),
                     .atlas = read_atlas(folder / "atlas.h5"),
                     .loaded = load_model(folder),
                     .error_maps = {}};
  require_one_model(folder, record);
  require_marks_on_model(folder, record);
  record.error_maps =
      read_error_maps(folder / "error_maps.h5", record.evaluation.names, record.loaded.model.landmarks(),
                      static_cast<int>(record.loaded.model.triangles().size()));
  return record;
}

ModelRecord record_as_written(RunRecord run, Evaluation evaluation, const BuildRecord& build) {
  std::vector<ErrorMap> error_maps;
  for (const ShapeRepresentation& shape : evaluation.representation.shapes)
    error_maps.push_back(in_single_precision(shape.map));
  LoadedModel loaded = loaded_as_written(build, run.command);
  return {std::move(run), std::move(evaluation), atlas_of(build.built), std::move(loaded),
          std::move(error_maps)};
}

}  // namespace foramen
