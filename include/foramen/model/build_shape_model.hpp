#pragma once
/// \file
/// The third stage: alignment and principal components of corresponding shapes.

#include <array>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/model/landmark_weights.hpp"
#include "foramen/model/procrustes.hpp"
#include "foramen/model/shape_model.hpp"

namespace foramen {

struct ShapeModelOptions {
  ScaleMode scale = ScaleMode::keep;
  LandmarkWeights weights = LandmarkWeights::equal;  ///< in the alignment and the model
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<ShapeModelOptions> auto& o) {
  visit(o.scale, {.name = "scale", .meaning = "keep or remove the shapes' size"});
  visit(o.weights,
        {.name = "landmark_weights", .meaning = "what landmarks count for: all alike, or by their area"});
}

struct AlignedModel {
  ProcrustesResult alignment;  ///< what the model was made of
  ShapeModel model;
};

/// Generalized Procrustes alignment (procrustes()) and the principal components of the aligned shapes
/// (model_of_aligned()), both with the landmarks' weights (landmark_weights()).
/// \param shapes  corresponding points of each, in any pose, mm
/// Throws InvalidInput if the shapes are the same but for their pose, so that there is no variation, and what
/// procrustes() throws.
AlignedModel build_shape_model(const std::vector<std::vector<Vec3>>& shapes,
                               const std::vector<std::array<int, 3>>& triangles,
                               const ShapeModelOptions& options = {});

}  // namespace foramen
