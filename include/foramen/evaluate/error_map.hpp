#pragma once
/// \file
/// The local deviation of a corresponding mesh from its input surface.

#include <vector>

#include "foramen/spatial/flips.hpp"

namespace foramen {

/// Errors per landmark and flipped triangles of one shape.
struct ErrorMap {
  std::vector<double> landmark_mm;  ///< per landmark: the largest distance in its neighbourhood, mm
  std::vector<int> plain_flips;     ///< indices of triangles, in order; see SampledFlips
  std::vector<int> confirmed_flips;
};

/// Distances in both directions. The distance of each input vertex to the corresponding mesh counts for the
/// landmark with the largest barycentric coordinate at the closest point. The distances of each landmark and
/// of the midpoints of landmark edges and triangles to the input count for their landmarks. The maximum of a
/// map is a lower bound of the Hausdorff distance, as is that of surface_distance().
ErrorMap error_map(const TriangleTree& corresponding, const TriangleTree& input, const SampledFlips& flips);

}  // namespace foramen
