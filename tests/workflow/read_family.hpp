#pragma once
/// \file
/// The family of support/torus_family.hpp in the form of shapes that were read from files.

#include "support/torus_family.hpp"
#include "workflow/build_from.hpp"

namespace foramen::testing {

inline InputShape input(const Shape& shape) {
  InputShape input;
  input.stem = shape.name;
  input.file_name = std::string(shape.name).append(".ply");
  input.mesh = shape.mesh;
  return input;
}

inline Cohort read(const std::vector<Shape>& shapes) {
  Cohort cohort;
  for (const Shape& shape : shapes) cohort.shapes.push_back(input(shape));
  return cohort;
}

/// A build of the family.
inline BuildRecord family_build(const BuildOptions& options) {
  return build_from(read(family()), options, RunContext(2));
}

}  // namespace foramen::testing
