#pragma once
/// \file
/// What a model says of a shape that has its landmarks.

#include <span>
#include <string>
#include <vector>

#include "foramen/evaluate/generalization.hpp"

namespace foramen {

struct ProjectedShape {
  SimilarityTransform to_model;  ///< shape's coordinates -> the model's
  Eigen::VectorXd scores;        ///< of all modes, in standard deviations
  std::vector<Vec3> fit;         ///< the closest shape that the model has, in the shape's coordinates, mm
  double landmark_rms = 0;       ///< of fit and landmarks, ShapeModel::landmark_rms, in model coordinates, mm
};

/// The shape aligned to the mean as a build aligns its own (align_to_mean()), its scores on all modes, and
/// the shape of those scores. Invariant under rigid motion of the landmarks. Throws InvalidInput for another
/// number of landmarks than the model's.
ProjectedShape project_shape(std::span<const Vec3> landmarks, const AlignedModel& model, ScaleMode scale);

/// The model of the other shapes: Procrustes and PCA anew, with the model's triangles and weights. No
/// correspondence is computed anew: it has seen the shapes left out. Throws InvalidInput, with the names
/// there are, for a name that no shape has, or if fewer than 2 shapes remain. \param names  one per shape of
/// the model
AlignedModel model_without(const AlignedModel& model, std::span<const std::string> names,
                           std::span<const std::string> left_out, ScaleMode scale);

}  // namespace foramen
