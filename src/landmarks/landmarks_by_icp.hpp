#pragma once
/// \file
/// Private to landmarks: the baseline's way.

#include "foramen/landmarks/place_landmarks.hpp"

namespace foramen {

/// The reference remeshed; every landmark carried to its closest compatible point on each aligned shape. All
/// but the names is filled in.
Landmarks landmarks_by_icp(const std::vector<Mesh>& shapes, const CohortRegistration& cohort,
                           const PlaceLandmarksOptions& options, const RunContext& ctx);

/// The same landmarks on one more shape, which is aligned to the reference first.
std::vector<Vec3> newcomers_landmarks_by_icp(const Mesh& shape, const CohortRegistration& cohort,
                                             const Landmarks& landmarks, const RunContext& ctx);

}  // namespace foramen
