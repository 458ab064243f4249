#pragma once
/// \file
/// Points that belong to no triangle, as programs leave them behind when they cut a surface.

#include <optional>

#include "foramen/core/mesh.hpp"
#include "foramen/core/remedy.hpp"

namespace foramen {

/// Removes the points that belong to no triangle, since they do not matter to the surface, and returns a note
/// on it. A surface with a triangle whose corner does not exist stays as it is.
std::optional<Message> drop_unused_points(TriangleSoup& surface);

}  // namespace foramen
