#pragma once
/// \file
/// A torus that no motion but the identity maps onto itself, so that alignment has one answer.

#include <cmath>

#include "support/meshes.hpp"

namespace foramen::testing {

/// \param strength  of one bump: shapes of different strength are different shapes of one family
inline TriangleSoup lopsided_torus_soup(int around, int tube, double strength = 1.0) {
  TriangleSoup soup = torus_soup(around, tube);
  for (Vec3& p : soup.points) {
    const double u = std::atan2(p.y(), p.x());
    p.x() *= 1.5;
    p += Vec3(4 * std::cos(2 * u), 3 * std::sin(3 * u),
              strength * 6 * std::exp(std::cos(u - 0.7) - 1) + 2 * std::sin(2 * u + 1));
    p.z() += 0.02 * p.x() * p.x();
  }
  return soup;
}

}  // namespace foramen::testing
