#pragma once
/// \file
/// From the map of the working mesh to a map of the input mesh.

#include "foramen/parameterize/torus_map.hpp"
#include "simplify/working_mesh.hpp"

namespace foramen {

/// Undoes the collapses one by one: each vertex comes back inside the kernel of its one-ring in the plane,
/// which is never empty (near the vertex it went into), so no triangle flips. Positions inside the kernel
/// come from the surface (mean-value weights, \cite floater2003), moved towards the kernel's centre until
/// well inside, then by two Newton steps to less distortion (distortion.hpp); when all are back each returned
/// vertex takes two more steps among its neighbours of the input. Vertices of the working mesh stay where
/// they are.
///
/// The lattice is that of `coarse`; a returned vertex lies beside the one it went into without a jump, so
/// positions may lie outside [0, 1)^2 (see wrapped()). Throws InvalidInput if the three do not belong
/// together or `coarse` has a triangle without positive area, ConvergenceError, naming the vertex, where the
/// triangles are too small in the plane for double precision.
TorusMap refine_map(const Mesh& input, const WorkingMesh& working, const TorusMap& coarse);

}  // namespace foramen
