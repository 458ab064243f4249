#pragma once
/// \file
/// A whole build from files to files: read, build, evaluate, write.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/evaluate/evaluate.hpp"
#include "foramen/stages/build_model.hpp"
#include "inputs/read_cohort.hpp"

namespace foramen {

struct BuildRequest {
  std::vector<std::filesystem::path> inputs;  ///< files and folders
  std::filesystem::path output;               ///< the model's folder
  LengthUnit unit = LengthUnit::millimetre;   ///< of the meshes among them
  std::optional<LabelRequest> labels =
      std::nullopt;  ///< of the label maps among them; unset: all with a name
  std::optional<RepairOptions> repair = std::nullopt;  ///< set: what the audit refuses is repaired
  BuildOptions build = {};
  EvaluationOptions evaluation = {};
  bool refit = false;           ///< also refit_generalization(): as many builds as there are shapes
  std::string subject_pattern;  ///< regular expression on stems; empty: subjects unknown
  std::filesystem::path truth;  ///< folder of true correspondence; empty: unknown
  bool resume = false;          ///< take up what an interrupted build left in the model's folder
  /// Folder that keeps finished stages after success too, for later and other builds; empty: none.
  std::filesystem::path store;
  std::string canonical_command;  ///< recorded in the files
};

struct BuildSummary {
  std::vector<LeftOut> left_out;
  std::vector<Message> notes;  ///< what the user should know though it is no error
  std::string text;            ///< a few lines for a terminal
  std::string json;            ///< the same as one object
};

/// Finished stages are kept in the model's folder until all is written, so that an interrupted build can be
/// resumed to the same bytes. Writes every file of the model's folder, each whole or not at all. Throws the
/// errors of its stages.
BuildSummary run_build(const BuildRequest& request, const RunContext& ctx);

}  // namespace foramen
