#pragma once
/// \file
/// Evaluation of corresponding meshes that any tool made.

#include <filesystem>
#include <string>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/evaluate.hpp"

namespace foramen {

struct EvaluateFolderRequest {
  std::filesystem::path
      corresponding;  ///< folder of corresponding meshes, or a model's folder (its corresponding/)
  std::filesystem::path
      shapes;  ///< folder of the original surfaces; empty: distances are measured to the corresponding meshes
  std::filesystem::path truth;           ///< folder of the true correspondence; empty: unknown
  std::filesystem::path true_landmarks;  ///< folder to write true_landmarks() to, as corresponding meshes
                                         ///< that can be evaluated in turn; empty: not written. Needs truth.
  std::filesystem::path output;          ///< folder for the metrics; empty: not written
  std::string subject_pattern;
  EvaluationOptions options = {};
};

struct EvaluatedFolder {
  Evaluation evaluation;
  std::string text, json;
};

/// Throws InvalidInput if meshes do not correspond or a shape is missing.
EvaluatedFolder evaluate_folder(const EvaluateFolderRequest& request, const RunContext& ctx);

}  // namespace foramen
