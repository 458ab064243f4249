#pragma once

#include "foramen/pipeline/build_model.hpp"

namespace foramen {

/// Landmarks on the torus, chosen on the mean of all shapes, and their places on every shape (filled into the
/// outcomes). The last stage of the torus method before the model.
void place_landmarks(ModelBuild& build, const PlaceLandmarksOptions& options, const RunContext& ctx);

/// The baseline: the reference remeshed, every landmark carried to its closest compatible point on each
/// aligned shape.
void place_landmarks_by_icp(ModelBuild& build, const PlaceLandmarksOptions& options, const RunContext& ctx);

}  // namespace foramen
