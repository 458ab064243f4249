#pragma once
/// \file
/// The local deviation of a corresponding mesh from its input surface.

#include <vector>

#include "foramen/evaluate/representation.hpp"
#include "spatial/flips.hpp"

namespace foramen {

/// Distances in both directions. The distance of each input vertex to the corresponding mesh counts for the
/// landmark with the largest barycentric coordinate at the closest point. The distances of each landmark and
/// of the midpoints of landmark edges and triangles to the input count for their landmarks. The maximum of a
/// map is a lower bound of the Hausdorff distance, as is that of surface_distance().
ErrorMap error_map(const TriangleTree& corresponding, const TriangleTree& input, const SampledFlips& flips);

}  // namespace foramen
