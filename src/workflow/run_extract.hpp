#pragma once
/// \file
/// The conversion of label maps to mesh files.

#include <filesystem>
#include <string>
#include <vector>

#include "inputs/read_cohort.hpp"

namespace foramen {

struct ExtractRequest {
  std::vector<std::filesystem::path> inputs;  ///< label maps, and folders of them
  std::filesystem::path output;               ///< folder of the meshes
  LabelRequest labels = {};
  std::optional<RepairOptions> repair = std::nullopt;  ///< if set, unusable surfaces are repaired
  std::string canonical_command;                       ///< recorded in extract.json
};

struct ExtractSummary {
  std::vector<LeftOut> left_out;
  std::vector<Message> notes;  ///< what the user should know though it is no error
  std::string text;            ///< a line a surface
  std::string json;            ///< what extract.json holds
};

/// Writes output/STEM.ply for every label (LPS, mm) and output/extract.json, which records the origin of each
/// surface and its distance to the voxels. Surfaces that cannot be used for a model (genus other than 1) are
/// written as well, with a remark. Nothing is written before all label maps have been read. Throws
/// InvalidInput if there is no input, if two stems are equal, if a label that was given by itself is missing,
/// or if there is no surface at all. Throws IoError.
ExtractSummary run_extract(const ExtractRequest& request, const RunContext& ctx);

}  // namespace foramen
