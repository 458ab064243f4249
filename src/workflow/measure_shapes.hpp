#pragma once
/// \file
/// Measures of all shapes of a model, or of any meshes with the model's landmarks.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/apply/measure_shape.hpp"
#include "foramen/core/remedy.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

/// The measurer of these definitions on the mean of a model. Throws InvalidInput as Measurer does; the
/// message names the source of the definitions, for example their file.
Measurer measurer_of(const ShapeModel& model, const MeasureDefinitions& definitions,
                     const std::string& source);

struct MeasuredShape {
  std::string name;  ///< stem of the file
  ShapeMeasures measures;
};

struct MeasuredFiles {
  std::vector<MeasuredShape> shapes;  ///< in order of stem
  std::vector<Message> notes;         ///< what the user should know though it is no error
};

/// The measures of corresponding mesh files. A folder stands for the mesh files directly in it. Throws
/// InvalidInput, which names the file, if a file does not have the model's triangles or is no vertebra's
/// size. Throws IoError.
MeasuredFiles measure_files(const Measurer& measurer, const std::vector<std::filesystem::path>& inputs,
                            const InputUnit& unit, const RunContext& ctx);

}  // namespace foramen
