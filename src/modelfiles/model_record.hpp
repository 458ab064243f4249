#pragma once
/// \file
/// What the files of a model's folder hold.

#include <filesystem>
#include <vector>

#include "foramen/evaluate/evaluate.hpp"
#include "foramen/evaluate/representation.hpp"
#include "modelfiles/atlas.hpp"
#include "modelfiles/model_folder.hpp"
#include "modelfiles/run_file.hpp"

namespace foramen {

struct ModelRecord {
  RunRecord run;
  Evaluation evaluation;  ///< with the items of shapes
  Atlas atlas;
  LoadedModel loaded;
  std::vector<ErrorMap> error_maps;  ///< one per shape
};

/// Reads the files. Throws IoError if a file is missing or broken, or if the files belong to different
/// models.
ModelRecord read_model_record(const std::filesystem::path& folder);

/// The same of a build that is not read back. All numbers that a file holds in single precision have it here
/// too, so that a page of this record is the page of the folder.
ModelRecord record_as_written(RunRecord run, Evaluation evaluation, const BuildRecord& build);

}  // namespace foramen
