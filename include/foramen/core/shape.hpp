#pragma once
/// \file
/// A surface with the name by which results speak of it.

#include <span>
#include <string>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// One shape of a cohort: a closed manifold surface, wound outward, mm. Names are unique within a cohort.
/// Copies share the mesh.
struct Shape {
  std::string name;
  Mesh mesh;
};

/// The shape of this name. Throws InvalidInput if there is none.
const Shape& shape_named(std::span<const Shape> shapes, const std::string& name);

}  // namespace foramen
