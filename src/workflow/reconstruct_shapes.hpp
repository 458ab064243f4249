#pragma once
/// \file
/// Shapes of given scores, from files to files.

#include <filesystem>

#include "foramen/core/run_context.hpp"

namespace foramen {

struct ReconstructRequest {
  std::filesystem::path model;  ///< a model's folder, or its model.h5
  /// CSV with the columns shape, mode1, mode2 ... in standard deviations; a mode without a column is 0.
  std::filesystem::path scores;
  std::filesystem::path output;  ///< folder to write
};

/// Writes NAME.ply, in model coordinates, for every row of the scores; returns how many. Throws IoError, also
/// if the table has not these columns, a name cannot be a file's or a score is not finite.
int reconstruct_shapes(const ReconstructRequest& request, const RunContext& ctx);

}  // namespace foramen
