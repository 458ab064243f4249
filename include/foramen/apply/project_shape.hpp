#pragma once
/// \file
/// Projection of a shape with the model's landmarks onto the model.

#include <span>
#include <string>
#include <vector>

#include "foramen/evaluate/generalization.hpp"

namespace foramen {

/// The projection of a shape onto a model.
struct ProjectedShape {
  SimilarityTransform to_model;  ///< maps coordinates of the shape to those of the model
  Eigen::VectorXd scores;        ///< scores on all modes, in standard deviations
  std::vector<Vec3> fit;         ///< the closest shape of the model, in the coordinates of the shape, mm
  /// ShapeModel::landmark_rms() between fit and landmarks, in model coordinates, mm.
  double landmark_rms = 0;
};

/// Aligns the shape to the mean (align_to_mean()), computes its scores on all modes and reconstructs the
/// shape from them. The scores are invariant under rigid motion of the landmarks. Throws InvalidInput if the
/// number of landmarks differs from that of the model.
ProjectedShape project_shape(std::span<const Vec3> landmarks, const AlignedModel& model, ScaleMode scale);

/// The model without some of its shapes: repeats the Procrustes alignment and the PCA, with the triangles and
/// weights of the model. The correspondence is not recomputed, so it still depends on the shapes that are
/// left out. Throws InvalidInput for a name that no shape has (the message lists the names) and if fewer than
/// 2 shapes remain.
/// \param names  one per shape of the model
AlignedModel model_without(const AlignedModel& model, std::span<const std::string> names,
                           std::span<const std::string> left_out, ScaleMode scale);

}  // namespace foramen
