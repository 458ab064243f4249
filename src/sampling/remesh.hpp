#pragma once
/// \file
/// Curvature-adaptive isotropic remeshing of the mean shape, with torus coordinates for every landmark.

#include <array>
#include <cstdint>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "foramen/sampling/sampling_options.hpp"

namespace foramen {

/// Isotropic remeshing of the dense mean `surface` after \cite fuhrmann2010, in another order: halfedge
/// collapses down to (or edge splits up to) exactly options.landmarks vertices, the edge that is shortest in
/// the density's metric first; Delaunay flips; Lloyd relaxation weighted by density, each landmark moved
/// within its one-ring and put back on the surface through the torus; Delaunay flips.
///
/// Every landmark lies on the surface; the triangles are an embedded triangulation of the torus at every step
/// (exactly, in steps of 2^-40 turns), no two edges join the same two landmarks, and the genus is kept. The
/// same for any number of threads.
///
/// \param density  samples per area up to a factor, per vertex of `surface`, > 0; see curvature_density()
///
/// Throws InvalidInput (an option out of its range: fewer than 16 landmarks cannot triangulate most tori
/// without joining two of them twice; a density that is not positive; a map with flipped triangles) or ConvergenceError (the surface cannot be thinned out that far).
LandmarkMesh remesh(const Mesh& surface, const TorusMap& map, const VertexMap<double>& density,
                    const RunContext& ctx, const RemeshOptions& options = {});

}  // namespace foramen
