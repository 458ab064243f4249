#pragma once
/// \file
/// A mesh of a part of a surface, as it was cut or segmented.

#include "foramen/core/mesh.hpp"

namespace foramen {

/// The triangles as a manifold mesh, usually open: triangles without area are dropped, vertices that no
/// triangle uses too, and a vertex whose triangles form several fans becomes several vertices at its place.
/// Throws InvalidInput where no triangle is left, and what build_mesh() throws: an edge with more than two
/// triangles, or two of the same direction.
Mesh part_surface(const TriangleSoup& soup);

}  // namespace foramen
