#pragma once
/// \file
/// Label maps to meshes, from files to files.

#include <filesystem>
#include <string>
#include <vector>

#include "inputs/read_cohort.hpp"

namespace foramen {

struct ExtractRequest {
  std::vector<std::filesystem::path> inputs;  ///< label maps, and folders of them
  std::filesystem::path output;               ///< folder of the meshes
  LabelRequest labels = {};
  std::optional<RepairOptions> repair = std::nullopt;  ///< Set: what is unfit for a model is repaired.
  std::string canonical_command;                       ///< recorded in extract.json
};

struct ExtractSummary {
  std::vector<LeftOut> left_out;
  std::vector<Message> notes;  ///< what the user should know though it is no error
  std::string text;            ///< a line a surface
  std::string json;            ///< what extract.json holds
};

/// Writes output/STEM.ply for every label (LPS mm) and output/extract.json, the record of where they came
/// from and how far they are from the voxels. Surfaces that are unfit for a model (genus other than 1) are
/// written too, and noted. Throws InvalidInput: no input, equal stems, a label named singly that is not
/// there, no surface at all; IoError. Nothing is written before all label maps are read.
ExtractSummary run_extract(const ExtractRequest& request, const RunContext& ctx);

}  // namespace foramen
