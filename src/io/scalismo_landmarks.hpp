#pragma once
/// \file
/// Named points of one shape as Scalismo keeps them: a JSON list of {id, coordinates, description}.

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

/// Throws InvalidInput if an id is empty or comes twice, a coordinate is not finite or a text not UTF-8;
/// IoError.
void write_scalismo_landmarks(const std::filesystem::path& path, std::span<const ScalismoLandmark> landmarks);

/// Uncertainties and other members are passed over. Throws IoError naming the landmark and what is wrong.
std::vector<ScalismoLandmark> read_scalismo_landmarks(const std::filesystem::path& path);

}  // namespace foramen
