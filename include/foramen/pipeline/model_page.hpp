#pragma once
/// \file
/// The report of a model.

#include <filesystem>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "foramen/evaluate/evaluate_model.hpp"
#include "foramen/pipeline/atlas_file.hpp"

namespace foramen {

/// report.html from what the model's other files hold. Times and memory in `run` are not used, so that the
/// same build gives the same bytes. \param run  the contents of run.json
std::string model_page(const nlohmann::ordered_json& run, const Evaluation& evaluation, const Atlas& atlas,
                       const ShapeModel& model);

/// The same from a model's folder. Throws IoError if a file is missing or broken.
std::string model_page(const std::filesystem::path& folder);

/// What a terminal shows at the end of a build: a few lines.
std::string model_summary(const nlohmann::ordered_json& run, const Evaluation& evaluation);

}  // namespace foramen
