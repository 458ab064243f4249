#pragma once
/// \file
/// Folders of corresponding meshes: those of foramen, of another tool, or the truth of a synthetic set.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/core/remedy.hpp"
#include "foramen/core/units.hpp"
#include "foramen/evaluate/truth_error.hpp"
#include "foramen/io/mesh_file.hpp"

namespace foramen {

/// Meshes with identical triangles. Reading throws InvalidInput, which names the first mesh with other
/// triangles or whose size is no vertebra's.
struct CorrespondingFolder {
  std::vector<std::string> names;  ///< stems, sorted
  std::vector<std::array<int, 3>> triangles;
  std::vector<std::vector<Vec3>> shapes;  ///< mm
  std::vector<AnatomicalSpace> spaces;    ///< one per shape; LPS if a file has no tag
  /// The folder that tells each file apart, see ShapeFile; empty if the names of the files do.
  std::vector<std::string> folders = {};
  std::vector<Message> notes = {};  ///< on the search, the files and their sizes, see SizeCheck
};
CorrespondingFolder read_corresponding(const std::filesystem::path& folder, const InputUnit& unit = {});

/// The true correspondence of the shapes of these names. Throws InvalidInput if the folder lacks one.
TrueCorrespondence read_truth(const std::filesystem::path& folder, const std::vector<std::string>& names,
                              const InputUnit& unit = {});

}  // namespace foramen
