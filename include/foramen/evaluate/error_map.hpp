#pragma once
/// \file
/// Where on a shape its corresponding mesh departs from the input surface.

#include <vector>

#include "foramen/spatial/flips.hpp"

namespace foramen {

struct ErrorMap {
  std::vector<double> landmark_mm;  ///< per landmark: the largest distance found in its surroundings, mm
  std::vector<int> plain_flips;     ///< triangles, as SampledFlips, in order
  std::vector<int> confirmed_flips;
};

/// Distances both ways: of each vertex of the input to the corresponding mesh, counted for the landmark whose
/// barycentric coordinate is largest at the closest point; of each landmark, and of the middle of each
/// landmark edge and triangle, to the input, counted for its landmarks. The largest of a map is a lower bound
/// of the Hausdorff distance, as that of surface_distance() is.
ErrorMap error_map(const TriangleTree& corresponding, const TriangleTree& input, const SampledFlips& flips);

}  // namespace foramen
