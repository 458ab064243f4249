#pragma once
/// \file
/// A mesh of a part of a surface, as it was cut or segmented.

#include "foramen/core/mesh.hpp"

namespace foramen {

/// The triangles as a manifold mesh, usually open: triangles without area are dropped, vertices that no
/// triangle uses too, and where triangles do not form one sheet they are taken apart. A vertex whose
/// triangles form several fans becomes several vertices at its place; of more than two triangles at an edge,
/// or two of the same direction, two that fit together stay joined. Throws InvalidInput where no triangle is
/// left or one uses a vertex that is not there.
Mesh part_surface(const TriangleSoup& soup);

}  // namespace foramen
