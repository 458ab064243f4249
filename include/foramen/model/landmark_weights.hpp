#pragma once
/// \file
/// What each landmark counts for in alignment, PCA and landmark distances.

#include <array>
#include <string_view>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/model/procrustes.hpp"

namespace foramen {

enum class LandmarkWeights {
  equal,  ///< every landmark alike: where landmarks are dense, shape counts for more
  area    ///< by the area around it: every part of the surface alike
};

template <>
struct EnumWords<LandmarkWeights> {
  static constexpr std::pair<std::string_view, LandmarkWeights> all[] = {{"equal", LandmarkWeights::equal},
                                                                         {"area", LandmarkWeights::area}};
};

/// Empty for LandmarkWeights::equal. For area \f$ w_i = P A_i / \sum_j A_j \f$, of mean 1: A_i is a third of
/// the areas of the triangles at landmark i (vertex_areas) on the mean of the unweighted generalized
/// Procrustes alignment of the shapes, at the same ScaleMode. Rigid motion of any shape changes nothing.
/// Throws what procrustes() and build_mesh() throw, and InvalidInput for a landmark around which the mean has
/// no area.
std::vector<double> landmark_weights(const std::vector<std::vector<Vec3>>& shapes,
                                     const std::vector<std::array<int, 3>>& triangles, ScaleMode scale,
                                     LandmarkWeights kind);

}  // namespace foramen
