#pragma once
/// \file
/// Which shape a file beside the surfaces belongs to, by its name and folders.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace foramen {

struct ShapeOfFile {
  int shape = 0;     ///< index of the name
  std::string rest;  ///< what the file's name adds to that of the shape; may be empty
};

/// The shape that a file is of: its stem is the shape's name, or begins with it before '_', '-', '.' or ' '
/// ("L1_07_rims" of L1_07); or so is FOLDER_STEM with a folder above it, as a shape of several folders is
/// named; or a folder above it has the shape's name ("L1_07/rims"). The longest name that fits is taken.
/// nullopt if none does.
/// \param stem  the file name without its extension
std::optional<ShapeOfFile> shape_of_file(const std::filesystem::path& file, const std::string& stem,
                                         const std::vector<std::string>& names);

}  // namespace foramen
