#pragma once
/// \file
/// Relaxation of landmarks towards the centroids of their Voronoi cells.

#include "foramen/core/run_context.hpp"
#include "sampling/landmark_state.hpp"

namespace foramen::detail {

/// One round: every landmark moves towards (and, over-relaxed, beyond) the centroid of its Voronoi cell in
/// its unfolded one-ring, all from the old positions. Weighted by density^2, so that cells of equal mass end
/// up `density` to the area (the Voronoi cells of weight w settle at sqrt(w) samples to the area). Moves that
/// would turn a triangle of the torus over are halved, then taken back.
void lloyd_round(LandmarkState& landmarks, const DenseSurface& surface, const RunContext& ctx);

}  // namespace foramen::detail
