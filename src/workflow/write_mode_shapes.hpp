#pragma once
/// \file
/// The mean of a model moved along each mode, as files.

#include <filesystem>
#include <vector>

#include "foramen/core/remedy.hpp"

namespace foramen {

struct ModeShapesRequest {
  std::filesystem::path model;   ///< a model's folder, or its model.h5
  std::filesystem::path output;  ///< folder to write
  double sd = 2;                 ///< how far, in standard deviations of the mode. > 0
};

struct ModeShapesSummary {
  int files = 0;
  std::vector<Message> notes;  ///< on how the model was read
};

/// Writes what write_modes() writes: two meshes a mode, in model coordinates. Throws IoError.
ModeShapesSummary write_mode_shapes(const ModeShapesRequest& request);

}  // namespace foramen
