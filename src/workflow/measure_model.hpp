#pragma once
/// \file
/// Measures that a file defines on the mean of a model, as a table.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"

namespace foramen {

struct MeasureRequest {
  std::filesystem::path model;                     ///< a model's folder
  std::filesystem::path definitions;               ///< see read_measures()
  std::filesystem::path output;                    ///< the CSV file to write
  std::vector<std::filesystem::path> meshes = {};  ///< files and folders; empty: the model's own shapes
  InputUnit unit = {};                             ///< of the meshes
};

struct MeasureSummary {
  std::size_t shapes = 0;            ///< rows of the table
  std::vector<std::string> columns;  ///< the first is the shape's name
  std::vector<Message> notes;        ///< what the user should know though it is no error
};

/// Writes a row a mesh, in order of stem. Throws what measurer_of() and measure_files() throw; IoError.
MeasureSummary measure_model(const MeasureRequest& request, const RunContext& ctx);

}  // namespace foramen
