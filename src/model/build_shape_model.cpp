#include "foramen/model/build_shape_model.hpp"

#include <cmath>
#include <utility>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

constexpr double least_variation_mm = 1e-5;  // per landmark; about the rounding of coordinates in files

}  // namespace

AlignedModel build_shape_model(const std::vector<std::vector<Vec3>>& shapes,
                               const std::vector<std::array<int, 3>>& triangles,
                               const ShapeModelOptions& options) {
  std::vector<double> weights = landmark_weights(shapes, triangles, options.scale, options.weights);
  AlignedModel result;
  result.alignment = procrustes(shapes, options.scale, weights);
  result.model = model_of_aligned(result.alignment.aligned, triangles, std::move(weights));
  if (std::sqrt(result.model.variance().sum() / result.model.total_weight()) < least_variation_mm)
    throw InvalidInput(
        "all shapes are the same but for their position: there is no variation to make a model of; are they "
        "copies of one file?");
  return result;
}

}  // namespace foramen
