#pragma once
/// \file
/// Private to landmarks: the placement of landmarks for the ICP baseline.

#include "foramen/landmarks/place_landmarks.hpp"

namespace foramen {

/// Remeshes the reference and moves every landmark to the closest compatible point on each aligned shape. The
/// names of the result are left empty.
Landmarks landmarks_by_icp(const std::vector<Mesh>& shapes, const CohortRegistration& cohort,
                           const PlaceLandmarksOptions& options, const RunContext& ctx);

/// The same landmarks on one further shape, which is first aligned to the reference.
std::vector<Vec3> newcomers_landmarks_by_icp(const Mesh& shape, const CohortRegistration& cohort,
                                             const Landmarks& landmarks, const RunContext& ctx);

}  // namespace foramen
