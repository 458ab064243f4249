#pragma once
/// \file
/// The error maps of all shapes, as a file.

#include <filesystem>
#include <string>
#include <vector>

#include "evaluate/error_map.hpp"
#include "foramen/evaluate/representation.hpp"

namespace foramen {

struct NamedErrorMap {
  std::string name;  ///< stem of the shape
  ErrorMap map;
};

/// Writes an HDF5 file with these paths, where P is the number of landmarks: /shapes/NAME/landmark_mm (P) in
/// single precision, and /shapes/NAME/plain_flips and /shapes/NAME/confirmed_flips, which hold indices of
/// landmark triangles.
void write_error_maps(const std::filesystem::path& path, const std::vector<NamedErrorMap>& maps);

/// The map that is read back of one that is written.
ErrorMap in_single_precision(ErrorMap map);

/// The maps of the shapes of these names, in their order. Throws IoError if one is missing or does not fit a
/// mesh of so many landmarks and triangles.
std::vector<ErrorMap> read_error_maps(const std::filesystem::path& path,
                                      const std::vector<std::string>& names, int landmarks, int triangles);

}  // namespace foramen
