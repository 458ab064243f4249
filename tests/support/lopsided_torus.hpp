#pragma once
/// \file
/// A torus that only the identity maps onto itself, so that alignment has a unique result.

#include <cmath>
#include <utility>

#include "support/meshes.hpp"

namespace foramen::testing {

/// \param strength  of one bump; shapes with different strengths are members of one family
inline TriangleSoup lopsided(TriangleSoup soup, double strength) {
  for (Vec3& p : soup.points) {
    const double u = std::atan2(p.y(), p.x());
    p.x() *= 1.5;
    p += Vec3(4 * std::cos(2 * u), 3 * std::sin(3 * u),
              strength * 6 * std::exp(std::cos(u - 0.7) - 1) + 2 * std::sin(2 * u + 1));
    p.z() += 0.02 * p.x() * p.x();
  }
  return soup;
}

inline TriangleSoup lopsided_torus_soup(int around, int tube, double strength = 1.0) {
  return lopsided(torus_soup(around, tube), strength);
}

/// The same torus with a wall: its tube, which is 16 mm high, is flattened in one place to the thickness 2 *
/// half_wall_mm, over about twice `width` radians of the ring.
inline TriangleSoup walled_torus_soup(int around, int tube, double strength, double half_wall_mm,
                                      double width) {
  TriangleSoup soup = torus_soup(around, tube);
  for (Vec3& p : soup.points) {
    const double x = (std::atan2(p.y(), p.x()) - 2) / width;
    const double half_width = 8 - (8 - half_wall_mm) * std::exp(-x * x / 2);
    const Vec3 centre = 20 * Vec3(p.x(), p.y(), 0).normalized();
    const Vec3 across = p - centre;
    p = centre + Vec3(half_width / 8 * across.x(), half_width / 8 * across.y(), across.z());
  }
  return lopsided(std::move(soup), strength);
}

/// The same torus with bumps all over, which distinguish each place from its neighbours.
inline TriangleSoup knobbly_torus_soup(int around, int tube) {
  TriangleSoup soup = torus_soup(around, tube);
  for (Vec3& p : soup.points) {
    const double u = std::atan2(p.y(), p.x());
    const Vec3 centre(20 * std::cos(u), 20 * std::sin(u), 0);
    const Vec3 across = (p - centre) / 8;
    const double v = std::atan2(across.z(), across.dot(centre.normalized()));
    p += (1.2 * std::sin(5 * u + 1) * std::cos(3 * v) + 0.8 * std::cos(7 * u - 2 * v)) * across;
    p.x() *= 1.5;
    p += Vec3(4 * std::cos(2 * u), 3 * std::sin(3 * u), 6 * std::exp(std::cos(u - 0.7) - 1));
  }
  return soup;
}

}  // namespace foramen::testing
