#pragma once
/// \file
/// The mesh of a part of a surface, for example of a cut or partial segmentation.

#include "foramen/core/mesh.hpp"

namespace foramen {

/// Makes a manifold mesh, usually open, from triangles. Triangles of zero area and unused vertices are
/// dropped, and triangles that do not form one sheet are separated: a vertex whose triangles form several
/// fans is duplicated; at an edge with more than two triangles, or with two of the same direction, two
/// triangles that fit together stay connected. Throws InvalidInput if no triangle is left or a triangle uses
/// a vertex that does not exist.
Mesh part_surface(const TriangleSoup& soup);

}  // namespace foramen
