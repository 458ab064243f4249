#pragma once
/// \file
/// The pose of a surface by its second moments, known up to a rotation of the axes among themselves.

#include <vector>

#include "foramen/core/geometry.hpp"

namespace foramen::detail {

struct PrincipalFrame {
  Vec3 centre;  ///< area-weighted centroid
  Mat3
      axes;  ///< columns: eigenvectors of the area-weighted covariance, smallest variance first, right-handed
};

PrincipalFrame principal_frame(const Mesh& mesh);

/// The 24 rotations that carry a frame of axes onto itself, signs and order aside.
std::vector<Mat3> proper_matchings();

}  // namespace foramen::detail
