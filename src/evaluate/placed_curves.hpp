#pragma once
/// \file
/// Curves on a corresponding mesh, made comparable point by point.

#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::detail {

/// The points of a curve in the direction, and of a closed one from the start, in which they are closest to
/// those of the other curve on this mesh by the sum of squared distances.
/// \pre both have the same number of points
std::vector<SurfacePoint> run_alike(const std::vector<SurfacePoint>& curve,
                                    const std::vector<SurfacePoint>& other, bool closed, const Mesh& mesh);

}  // namespace foramen::detail
