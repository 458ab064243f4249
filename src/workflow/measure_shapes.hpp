#pragma once
/// \file
/// Measures of all shapes of a model, or of any meshes with its landmarks.

#include <filesystem>
#include <string>
#include <vector>

#include "foramen/apply/measure_shape.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/core/units.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

/// Definitions bound to the mean of a model. Throws InvalidInput as Measurer does, naming the source of the
/// definitions, their file for example.
Measurer measurer_of(const ShapeModel& model, const MeasureDefinitions& definitions,
                     const std::string& source);

struct MeasuredShape {
  std::string name;  ///< stem of the file
  ShapeMeasures measures;
};

/// Of mesh files in correspondence (a folder means the mesh files directly in it), in order of stem. Throws
/// InvalidInput naming the file that has not the model's triangles; IoError.
std::vector<MeasuredShape> measure_files(const Measurer& measurer,
                                         const std::vector<std::filesystem::path>& inputs, LengthUnit unit,
                                         const RunContext& ctx);

}  // namespace foramen
