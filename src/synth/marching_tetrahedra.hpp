#pragma once
/// \file
/// The initial triangulation of an implicit surface by marching tetrahedra on a body-centred cubic lattice.

#include "synth/isosurface.hpp"

namespace foramen::synth {

/// The mesh is closed, manifold and wound outward for any function. Its vertices lie on lattice edges, at
/// positions that linear interpolation of the function gives. All points outside the bounds count as outside.
/// The soup is empty if no lattice point within the bounds is inside.
TriangleSoup march_tetrahedra(const ImplicitFunction& function, const BoundingBox& bounds, double spacing_mm,
                              const RigidTransform& lattice);

}  // namespace foramen::synth
