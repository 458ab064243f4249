#pragma once

#include <filesystem>
#include <vector>

#include <nlohmann/json.hpp>

#include "foramen/evaluate/evaluate.hpp"
#include "foramen/evaluate/representation.hpp"
#include "modelfiles/atlas_file.hpp"
#include "modelfiles/model_folder.hpp"

namespace foramen {

/// What the files of a model's folder hold.
struct ModelRecord {
  nlohmann::ordered_json run;  ///< run.json
  Evaluation evaluation;       ///< with the items of shapes
  Atlas atlas;
  LoadedModel loaded;
  std::vector<ErrorMap> error_maps;  ///< one per shape
};

/// Throws IoError if a file is missing or broken, or the files are not of one model.
ModelRecord read_model_record(const std::filesystem::path& folder);

/// Whether a shape of run.json is part of the model.
bool is_used(const nlohmann::ordered_json& shape);

}  // namespace foramen
