#pragma once
/// \file
/// From the map of the working mesh to a map of the input mesh.

#include "foramen/parameterize/torus_map.hpp"
#include "foramen/simplify/working_mesh.hpp"

namespace foramen {

/// Undoes the collapses one by one: each vertex comes back inside the kernel of its one-ring in the plane, which is
/// never empty (near the vertex it went into), so no triangle flips. \pre `coarse` has no flipped triangle.
/// Positions inside the kernel come from the surface (mean-value weights), moved towards the kernel's centre until well inside.
TorusMap refine_map(const Mesh& input, const WorkingMesh& working, const TorusMap& coarse);

}  // namespace foramen
