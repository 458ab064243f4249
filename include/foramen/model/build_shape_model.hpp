#pragma once
/// \file
/// The third stage: Procrustes alignment and principal component analysis of corresponding shapes.

#include <array>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/model/landmark_weights.hpp"
#include "foramen/model/procrustes.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

struct ShapeModelOptions {
  ScaleMode scale = ScaleMode::keep;
  /// Weights of the landmarks in the alignment and in the model.
  LandmarkWeights weights = LandmarkWeights::equal;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<ShapeModelOptions> auto& o) {
  visit(o.scale, {.name = "scale", .meaning = "keep or remove the shapes' size"});
  visit(o.weights,
        {.name = "landmark_weights", .meaning = "what landmarks count for: all alike, or by their area"});
}

/// A shape model and the alignment from which it was computed.
struct AlignedModel {
  ProcrustesResult alignment;  ///< the aligned shapes from which the model was computed
  ShapeModel model;
};

/// Aligns the shapes (procrustes()) and computes the principal components of the aligned shapes
/// (model_of_aligned()), both with the weights of landmark_weights(). Throws InvalidInput if the shapes
/// differ by their pose only, so that there is no variation, and what procrustes() and landmark_weights()
/// throw.
/// \param shapes  corresponding points of each shape, in any pose, mm
/// \param triangles  triangles over the points, the same for all shapes
AlignedModel build_shape_model(const std::vector<std::vector<Vec3>>& shapes,
                               const std::vector<std::array<int, 3>>& triangles,
                               const ShapeModelOptions& options = {});

}  // namespace foramen
