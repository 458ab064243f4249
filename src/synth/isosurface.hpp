#pragma once
/// \file
/// Closed manifold triangulation of an implicit surface.

#include <functional>

#include "foramen/core/geometry.hpp"
#include "foramen/core/mesh.hpp"

namespace foramen {

/// An implicit function at a point: negative inside, positive outside.
struct ImplicitValue {
  double value = 0;              ///< about the signed distance near the surface [mm]
  Vec3 gradient = Vec3::Zero();  ///< of the value; not zero near the surface
};

/// Continuously differentiable near its zero set.
using ImplicitFunction = std::function<ImplicitValue(const Vec3&)>;

struct IsosurfaceOptions {
  BoundingBox bounds{Vec3::Constant(-50),
                     Vec3::Constant(50)};  ///< Encloses the surface; nothing beyond it is seen [mm].
  double spacing_mm = 1.5;  ///< Side of the lattice's cubes: thinner parts of the solid or of its holes may
                            ///< be lost [mm]. > 0.
  RigidTransform lattice =
      RigidTransform::Identity();  ///< Where the lattice stands; another pose, another triangulation.
  int vertices =
      10000;       ///< Of the result, within 5 %. The triangles are nearly equilateral and equally large.
  int rounds = 5;  ///< Of splitting, collapsing, flipping and tangential smoothing. >= 0; 0 keeps the
                   ///< lattice's triangles.
};

/// The surface f = 0: closed, manifold, wound outward (towards growing f), with |f| <= 1e-8 mm at every
/// vertex.
///
/// Marching tetrahedra on a body-centred cubic lattice, whose surfaces are manifold for any signs, then
/// isotropic remeshing \cite botsch2004 in which vertices are projected to the surface itself; no step
/// changes the topology. Throws InvalidInput when the lattice meets no surface or options are out of range,
/// ConvergenceError when the number of vertices cannot be reached because the surface is too thin for
/// triangles of that size.
TriangleSoup isosurface(const ImplicitFunction& function, const IsosurfaceOptions& options = {});

}  // namespace foramen
