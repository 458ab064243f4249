#pragma once
/// \file
/// Fewer vertices, the rest spread by density.

#include "foramen/core/run_context.hpp"
#include "sampling/landmark_state.hpp"

namespace foramen::detail {

/// Halfedge collapses, the edge that is shortest in the density's metric first, with Delaunay flips in
/// between, down to exactly `vertices`. Throws ConvergenceError if no collapse is allowed any more.
void thin_out(LandmarkState& landmarks, int vertices, const RunContext& ctx);

/// Splits of the longest edges in the density's metric up to exactly `vertices`.
void fill_up(LandmarkState& landmarks, int vertices, const DenseSurface& surface, const RunContext& ctx);

}  // namespace foramen::detail
