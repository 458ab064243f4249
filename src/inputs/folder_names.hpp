#pragma once
/// \file
/// Folders that tell files of the same name apart.

#include <filesystem>
#include <string>
#include <vector>

namespace foramen {

/// A file whose shape's name without folder is known.
struct StemmedFile {
  std::filesystem::path path;
  std::string stem;  ///< with a mark if it is a label map, because such names may repeat a mesh's
};

/// For each file the name of the nearest folder, at the same distance for all files, with which all names are
/// different. Folders that all files share and folders that tell what kind of files they hold, such as
/// "segmentations", do not count. If no single folder suffices, all folders that the files do not share are
/// joined by _. Empty if folders cannot tell the files apart.
std::vector<std::string> folders_apart(const std::vector<StemmedFile>& files);

}  // namespace foramen
