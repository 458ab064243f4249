#pragma once
/// \file
/// Changes of the number of landmarks that follow the density.

#include "foramen/core/run_context.hpp"
#include "sampling/landmark_state.hpp"

namespace foramen::detail {

/// Halfedge collapses, with the edge that is shortest in the metric of the density first and Delaunay flips
/// in between, until exactly `vertices` are left. Throws ConvergenceError if no further collapse is allowed.
void thin_out(LandmarkState& landmarks, int vertices, const RunContext& ctx);

/// Splits the edges that are longest in the metric of the density until there are exactly `vertices`. Throws
/// ConvergenceError if no edge can be split.
void fill_up(LandmarkState& landmarks, int vertices, const DenseSurface& surface, const RunContext& ctx);

}  // namespace foramen::detail
