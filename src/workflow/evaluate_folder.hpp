#pragma once
/// \file
/// Evaluation of corresponding meshes that any tool made.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"
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
  std::vector<std::filesystem::path> marks = {};    ///< files and folders, see read_marks(); empty: none
  std::vector<std::filesystem::path> regions = {};  ///< files and folders, see read_regions(); empty: none
  std::filesystem::path output;                     ///< folder for the metrics; empty: not written
  InputUnit unit = {};          ///< of all these meshes and marks and of what is written; measures are in mm
  std::string subject_pattern;  ///< see subject_of(); empty: subjects as the model's files or folders say
  EvaluationOptions options = {};
};

struct EvaluatedFolder {
  Evaluation evaluation;
  std::string text, json;
  std::vector<Message> notes = {};  ///< what the user should know though it is no error
};

/// Throws InvalidInput if meshes do not correspond, a shape is missing, no vertebra has the size of one, or
/// marks or regions cannot be compared.
EvaluatedFolder evaluate_folder(const EvaluateFolderRequest& request, const RunContext& ctx);

}  // namespace foramen
