#pragma once
/// \file
/// Delaunay flips of the landmark triangulation.

#include "foramen/core/run_context.hpp"
#include "sampling/landmark_state.hpp"

namespace foramen::detail {

/// Flips edges whose two opposite angles in space sum to more than pi, provided that the triangulation of the
/// torus stays valid (TorusTriangulation::can_flip()) and the flip does not fold the surface more sharply.
/// Returns the number of flips.
int delaunay_flips(LandmarkState& landmarks, const RunContext& ctx);

}  // namespace foramen::detail
