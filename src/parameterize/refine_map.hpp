#pragma once
/// \file
/// Extends a map of the simplified mesh to the input mesh.

#include "foramen/parameterize/torus_map.hpp"
#include "simplify/working_mesh.hpp"

namespace foramen {

/// Undoes the collapses one by one. Each vertex is restored inside the kernel of its one-ring in the plane,
/// so no triangle flips. The kernel is never empty, because it contains points near the vertex into which the
/// restored one was collapsed. The position comes from mean-value weights on the surface \cite floater2003;
/// it is moved towards the centre of the kernel until it is well inside and then by two Newton steps that
/// decrease the distortion (distortion.hpp). When all vertices are restored, each of them takes two more
/// steps among its neighbours in the input. Vertices of the working mesh are not moved.
///
/// The lattice is that of `coarse`. A restored vertex has no jump to the vertex into which it was collapsed,
/// so positions may lie outside [0, 1)^2 (see wrapped()). Throws InvalidInput if the three arguments do not
/// belong together or `coarse` has a triangle without positive area. Throws ConvergenceError with the vertex
/// if triangles in the plane are too small for double precision.
TorusMap refine_map(const Mesh& input, const WorkingMesh& working, const TorusMap& coarse);

}  // namespace foramen
