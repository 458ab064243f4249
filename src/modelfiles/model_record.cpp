#include "modelfiles/model_record.hpp"

#include <fstream>

#include "foramen/core/error.hpp"
#include "modelfiles/error_maps_file.hpp"
#include "modelfiles/metrics_file.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

nlohmann::ordered_json read_run(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw IoError(file.string() + ": cannot be read; the build of a model writes it",
                  {{RemedyKind::build_model}});
  try {
    return nlohmann::ordered_json::parse(in);
  } catch (const nlohmann::json::exception& e) {
    throw IoError(file.string() + ": is not a run record of this version (" + e.what() + ")");
  }
}

void require_one_model(const fs::path& folder, const ModelRecord& record) {
  const std::size_t shapes = record.evaluation.names.size();
  const bool fits = record.loaded.names.size() == shapes &&
                    record.evaluation.representation.shapes.size() == shapes &&
                    record.loaded.scores.cols() == static_cast<Eigen::Index>(shapes) &&
                    record.evaluation.landmarks == record.loaded.model.landmarks() &&
                    std::ssize(record.atlas.landmarks.turns) == record.loaded.model.landmarks() &&
                    record.atlas.landmarks.triangles == record.loaded.model.triangles();
  if (!fits)
    throw IoError(folder.string() +
                  ": its files are not of one model (shapes or landmarks differ); build it again");
}

}  // namespace

bool is_used(const nlohmann::ordered_json& shape) { return shape.at("status") != "left out"; }

ModelRecord read_model_record(const fs::path& folder) {
  ModelRecord record{.run = read_run(folder / "run.json"),
                     .evaluation = read_metrics_of_shapes(folder),
                     .atlas = read_atlas(folder / "atlas.h5"),
                     .loaded = load_model(folder),
                     .error_maps = {}};
  require_one_model(folder, record);
  record.error_maps =
      read_error_maps(folder / "error_maps.h5", record.evaluation.names, record.loaded.model.landmarks(),
                      static_cast<int>(record.loaded.model.triangles().size()));
  return record;
}

}  // namespace foramen
