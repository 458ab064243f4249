#pragma once
/// \file
/// Private to landmarks: the placement of landmarks by maps to one torus.

#include "foramen/landmarks/place_landmarks.hpp"

namespace foramen {

/// Distributes landmarks over the dense mean of the shapes, repairs them and lifts them to all shapes. The
/// names of the result are left empty.
/// \param maps  one per shape; consumed
Landmarks landmarks_by_torus(const std::vector<Mesh>& shapes, std::vector<TorusMap> maps,
                             const PlaceLandmarksOptions& options, const RunContext& ctx);

}  // namespace foramen
