#pragma once
/// \file
/// Relaxation of landmarks towards the centroids of their Voronoi cells.

#include "foramen/core/run_context.hpp"
#include "sampling/landmark_state.hpp"

namespace foramen::detail {

/// One round of Lloyd relaxation. Every landmark moves towards the centroid of its Voronoi cell in its
/// unfolded one-ring, with over-relaxation; all moves are computed from the old positions. The centroids are
/// weighted by density^2, because Lloyd relaxation with weight w converges to a sampling density proportional
/// to sqrt(w). Moves that would flip a triangle of the torus are halved and finally taken back.
void lloyd_round(LandmarkState& landmarks, const DenseSurface& surface, const RunContext& ctx);

}  // namespace foramen::detail
