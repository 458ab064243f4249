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

namespace foramen {

/// Isotropic remeshing of the dense mean `surface` after \cite fuhrmann2010, with the steps in another order.
/// First, halfedge collapses (or edge splits) lead to exactly options.landmarks vertices; the edge that is
/// shortest (or longest) in the metric of the density comes first. After Delaunay flips follows Lloyd
/// relaxation weighted by the density, in which each landmark moves within its one-ring and is projected to
/// the surface through the torus. Delaunay flips come last again.
///
/// Every landmark lies on the surface. After every step the triangles are an embedded triangulation of the
/// torus, exactly for positions in multiples of 2^-40 turns, and no two edges join the same two landmarks.
/// The result does not depend on the number of threads.
///
/// \param density  one value > 0 per vertex of `surface`, proportional to the number of samples per area; see
/// curvature_density()
///
/// Throws InvalidInput for options out of range, a density that is not positive and a map with flipped
/// triangles. Fewer than 16 landmarks are out of range, because most tori have no triangulation with so few
/// vertices in which no two edges join the same two. Throws ConvergenceError if no further vertex can be
/// removed or added.
LandmarkMesh remesh(const Mesh& surface, const TorusMap& map, const VertexMap<double>& density,
                    const RunContext& ctx, const RemeshOptions& options = {});

}  // namespace foramen
