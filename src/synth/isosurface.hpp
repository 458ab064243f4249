#pragma once
/// \file
/// Closed manifold triangulation of an implicit surface.

#include <functional>

#include "foramen/core/geometry.hpp"
#include "foramen/core/mesh.hpp"

namespace foramen {

/// An implicit function at a point: negative inside, positive outside.
struct ImplicitValue {
  double value = 0;              ///< approximately the signed distance near the surface [mm]
  Vec3 gradient = Vec3::Zero();  ///< of the value; not zero near the surface
};

/// Continuously differentiable near its zero set.
using ImplicitFunction = std::function<ImplicitValue(const Vec3&)>;

struct IsosurfaceOptions {
  /// A box that encloses the surface; parts outside it are cut off [mm].
  BoundingBox bounds{Vec3::Constant(-50), Vec3::Constant(50)};
  /// Side of the cubes of the lattice; thinner parts of the solid or of its holes may be lost [mm]. > 0.
  double spacing_mm = 1.5;
  RigidTransform lattice =
      RigidTransform::Identity();  ///< Pose of the lattice; another pose gives another triangulation.
  /// Number of vertices of the result, within 5 %. Triangles are nearly equilateral and of nearly equal size.
  int vertices = 10000;
  /// Rounds of splits, collapses, flips and tangential smoothing. >= 0; 0 keeps the triangles of the lattice.
  int rounds = 5;
};

/// Triangulates the surface f = 0. The mesh is closed, manifold and wound outward (towards growing f), with
/// |f| <= 1e-8 mm at every vertex.
///
/// Marching tetrahedra on a body-centred cubic lattice give a mesh that is manifold for any signs of f. It is
/// followed by isotropic remeshing \cite botsch2004 that projects vertices to the implicit surface and does
/// not change the topology. Throws InvalidInput if the lattice finds no surface or options are out of range.
/// Throws ConvergenceError if the number of vertices cannot be reached because the surface is too thin for
/// triangles of that size.
TriangleSoup isosurface(const ImplicitFunction& function, const IsosurfaceOptions& options = {});

}  // namespace foramen
