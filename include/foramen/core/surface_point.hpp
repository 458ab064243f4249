#pragma once
/// \file
/// A point on a surface, given by its triangle and barycentric coordinates.

#include "foramen/core/mesh.hpp"

namespace foramen {

/// Barycentric coordinates in a face; they sum to 1, each >= 0 up to rounding.
struct SurfacePoint {
  FaceId face;
  Vec3 barycentric = Vec3::Zero();
};

/// The position in space, mm.
inline Vec3 position(const Mesh& mesh, const SurfacePoint& p) {
  const auto t = mesh.triangle(p.face);
  return p.barycentric[0] * t[0] + p.barycentric[1] * t[1] + p.barycentric[2] * t[2];
}

}  // namespace foramen
