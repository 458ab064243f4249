#pragma once
/// \file
/// Where on a shape its corresponding mesh departs from the input surface.

#include <vector>

#include "foramen/evaluate/representation.hpp"
#include "spatial/flips.hpp"

namespace foramen {

/// Distances both ways: of each vertex of the input to the corresponding mesh, counted for the landmark whose
/// barycentric coordinate is largest at the closest point; of each landmark, and of the middle of each
/// landmark edge and triangle, to the input, counted for its landmarks. The largest of a map is a lower bound
/// of the Hausdorff distance, as that of surface_distance() is.
ErrorMap error_map(const TriangleTree& corresponding, const TriangleTree& input, const SampledFlips& flips);

}  // namespace foramen
