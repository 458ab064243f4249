#pragma once
/// \file
/// The whole of a partial surface, from files to files.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/apply/complete_surface.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/core/units.hpp"

namespace foramen {

struct CompleteRequest {
  std::filesystem::path model;          ///< a model's folder
  std::filesystem::path surface;        ///< a mesh file, open or closed
  std::filesystem::path output;         ///< folder to write
  InputUnit unit = {};                  ///< of the surface and of what is written
  CompleteSurfaceOptions options = {};  ///< but for the scale, which is the model's
};

struct CompleteSummary {
  std::string text;            ///< a line for a terminal
  std::string json;            ///< what complete.json holds
  std::vector<Message> notes;  ///< what the user should know though it is no error
};

/// Writes, into the output folder, completed.ply with the standard deviation of every point, posterior.h5
/// (the model given the surface) and complete.json. Throws what complete_surface() throws; InvalidInput if
/// the surface cannot be used, IoError.
CompleteSummary complete_file(const CompleteRequest& request, const RunContext& ctx);

}  // namespace foramen
