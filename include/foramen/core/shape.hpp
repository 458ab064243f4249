#pragma once
/// \file
/// A surface with the name that identifies it in all results.

#include <span>
#include <string>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// One shape of a cohort: a closed manifold surface whose triangles are counter-clockwise seen from outside,
/// in mm. Names are unique within a cohort. Copies share the mesh.
struct Shape {
  std::string name;
  Mesh mesh;
};

/// Returns the shape of this name. Throws InvalidInput if there is none.
const Shape& shape_named(std::span<const Shape> shapes, const std::string& name);

}  // namespace foramen
