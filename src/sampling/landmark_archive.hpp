#pragma once
/// \file
/// Landmarks that are chosen, as bytes (byte_archive.hpp), to be kept.

#include "core/byte_archive.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "sampling/refine_landmarks.hpp"

namespace foramen {

template <class Archive>
void transfer(Archive& archive, MaybeConst<LandmarkMesh> auto& mesh) {
  archive(mesh.turns, mesh.triangles, mesh.jumps);
}

template <class Archive>
void transfer(Archive& archive, MaybeConst<RefinedLandmarks> auto& refined) {
  archive(refined.landmarks, refined.inserted, refined.flips, refined.moved, refined.initial,
          refined.remaining, refined.initial_self_intersections, refined.remaining_self_intersections);
}

}  // namespace foramen
