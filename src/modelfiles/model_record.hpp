#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "foramen/evaluate/evaluate.hpp"
#include "modelfiles/atlas_file.hpp"
#include "modelfiles/model_folder.hpp"

namespace foramen {

/// The contents of the files in a model's folder.
struct ModelRecord {
  nlohmann::ordered_json run;  ///< run.json
  Evaluation evaluation;       ///< with the values of each shape
  Atlas atlas;
  LoadedModel loaded;
  std::vector<ErrorMap> error_maps;  ///< one per shape
};

/// Reads the files. Throws IoError if a file is missing or broken, or if the files belong to different
/// models.
ModelRecord read_model_record(const std::filesystem::path& folder);

/// Whether this entry of run.json is a shape of the model, and not one that was left out.
bool is_used(const nlohmann::ordered_json& shape);

}  // namespace foramen
