#include "foramen/model/landmark_weights.hpp"

#include <string>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"

namespace foramen {

std::vector<double> landmark_weights(const std::vector<std::vector<Vec3>>& shapes,
                                     const std::vector<std::array<int, 3>>& triangles, ScaleMode scale,
                                     LandmarkWeights kind) {
  if (kind == LandmarkWeights::equal) return {};
  const Mesh mean = build_mesh({procrustes(shapes, scale).mean, triangles});
  std::vector<double> weights = vertex_areas(mean).values();
  const double mean_area = total_area(mean) / static_cast<double>(weights.size());
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (!(weights[i] > 0))
      throw InvalidInput(
          "landmark " + std::to_string(i) +
          ": its triangles have no area on the mean shape, so it has no area weight; take equal weights");
    weights[i] /= mean_area;
  }
  return weights;
}

}  // namespace foramen
