#pragma once
/// \file
/// Private to landmarks: landmarks placed through maps to one torus.

#include "foramen/landmarks/place_landmarks.hpp"

namespace foramen {

/// Landmarks spread over the dense mean of the shapes, mended, and lifted to all of them. All but the names
/// is filled in.
/// \param maps  one per shape; taken apart on the way
Landmarks landmarks_by_torus(const std::vector<Mesh>& shapes, std::vector<TorusMap> maps,
                             const PlaceLandmarksOptions& options, const RunContext& ctx);

}  // namespace foramen
