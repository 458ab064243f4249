#pragma once
/// \file
/// The pose of a surface by its second moments, which determine it up to 24 rotations that permute and
/// reverse the axes.

#include <vector>

#include "foramen/core/geometry.hpp"

namespace foramen::detail {

struct PrincipalFrame {
  Vec3 centre;  ///< area-weighted centroid, mm
  Mat3
      axes;  ///< columns: eigenvectors of the area-weighted covariance, smallest variance first, right-handed
};

PrincipalFrame principal_frame(const Mesh& mesh);

/// The 24 rotations that permute the coordinate axes and their directions.
std::vector<Mat3> proper_matchings();

}  // namespace foramen::detail
