#pragma once
/// \file
/// A plate with a hole, a horn and a hump. Plates differ in the place of the hole alone.

#include <cmath>

#include "foramen/core/geometry.hpp"
#include "support/meshes.hpp"

namespace foramen::testing {

/// The horn and the hump leave no second pose of the outline, so plates are aligned by it alone and their
/// holes lie apart by the difference of their offsets. The hole has a radius of 7 mm: the loops of one plate
/// have counterparts near them on another plate only if the holes overlap.
/// \param hole_mm  offset of the hole along the plate
/// \param size  factor of the whole plate
inline Mesh plate_with_hole(double hole_mm, double size = 1) {
  constexpr int around = 72, tube = 24;
  TriangleSoup soup = torus_soup(around, tube);
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < tube; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / tube;
      const Vec3 direction(std::cos(u), std::sin(u), 0);
      const double horn = 14 * std::exp(6 * (std::cos(u - 0.8) - 1));
      const Vec3 outer = Vec3(36 * direction.x(), 24 * direction.y(), 0) + horn * direction;
      const Vec3 inner = Vec3(hole_mm, 0, 0) + 7 * direction;
      Vec3& p = soup.points[i * tube + j];
      p = (outer + inner) / 2 + std::cos(v) * (outer - inner) / 2 + 5 * std::sin(v) * Vec3::UnitZ();
      p.z() += 6 * std::exp(std::cos(u - 2.4) - 1) + 0.006 * p.x() * p.x();
      p *= size;
    }
  return build_mesh(std::move(soup));
}

}  // namespace foramen::testing
