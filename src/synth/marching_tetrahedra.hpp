#pragma once
/// \file
/// The first triangulation of an implicit surface: marching tetrahedra on a body-centred cubic lattice.

#include "synth/isosurface.hpp"

namespace foramen::synth {

/// Closed and manifold for any function, wound outward; vertices on lattice edges, near the surface by linear
/// interpolation. Everything outside the bounds counts as outside. Empty if no lattice point in the bounds is
/// inside.
TriangleSoup march_tetrahedra(const ImplicitFunction& function, const BoundingBox& bounds, double spacing_mm,
                              const RigidTransform& lattice);

}  // namespace foramen::synth
