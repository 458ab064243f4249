#pragma once
/// \file
/// Named points of one shape in the landmark format of Scalismo: a JSON list of {id, coordinates,
/// description}.

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "foramen/core/geometry.hpp"

namespace foramen {

struct ScalismoLandmark {
  std::string id;
  Vec3 position;            ///< LPS mm
  std::string description;  ///< may be empty
};

/// Throws InvalidInput if an id is empty or occurs twice, a coordinate is not finite or a text is not UTF-8;
/// IoError if the file cannot be written.
void write_scalismo_landmarks(const std::filesystem::path& path, std::span<const ScalismoLandmark> landmarks);

/// Uncertainties and other members are ignored. Throws IoError with the landmark and what is wrong with it.
std::vector<ScalismoLandmark> read_scalismo_landmarks(const std::filesystem::path& path);

}  // namespace foramen
