#pragma once
/// \file
/// Weights of the landmarks in the alignment, in the PCA and in landmark distances.

#include <array>
#include <string_view>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/model/procrustes.hpp"

namespace foramen {

/// How landmarks are weighted.
enum class LandmarkWeights {
  equal,  ///< all landmarks count the same, so parts of the surface with denser landmarks count for more
  area    ///< a landmark counts by the area around it, so all parts of the surface count the same
};

template <>
struct EnumWords<LandmarkWeights> {
  static constexpr std::pair<std::string_view, LandmarkWeights> all[] = {{"equal", LandmarkWeights::equal},
                                                                         {"area", LandmarkWeights::area}};
};

/// Returns one weight per landmark, or an empty vector for LandmarkWeights::equal. For LandmarkWeights::area
/// the weights are \f$ w_i = P A_i / \sum_j A_j \f$ (dimensionless, mean 1) for P landmarks, where A_i is one
/// third of the area of the triangles at landmark i (vertex_areas()) on the mean shape of the unweighted
/// Procrustes alignment with the same ScaleMode. A rigid motion of any shape does not change them. Throws
/// what procrustes() and build_mesh() throw, and InvalidInput if the mean shape has no area around a
/// landmark.
std::vector<double> landmark_weights(const std::vector<std::vector<Vec3>>& shapes,
                                     const std::vector<std::array<int, 3>>& triangles, ScaleMode scale,
                                     LandmarkWeights kind);

}  // namespace foramen
