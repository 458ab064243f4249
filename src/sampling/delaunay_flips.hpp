#pragma once
/// \file
/// Delaunay edges for landmarks in space.

#include "foramen/core/run_context.hpp"
#include "sampling/landmark_state.hpp"

namespace foramen::detail {

/// Flips every edge whose two opposite angles in space sum to more than half a turn, as long as the
/// triangulation of the torus stays one (TorusTriangulation::can_flip) and the surface is not folded sharper
/// than it was. Returns the number of flips.
int delaunay_flips(LandmarkState& landmarks, const RunContext& ctx);

}  // namespace foramen::detail
