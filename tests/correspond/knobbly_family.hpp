#pragma once
/// \file
/// A family of tori with bumps whose correspondence is known by a formula.

#include <vector>

#include "sampling/mapped_tori.hpp"
#include "support/meshes.hpp"

namespace foramen::testing {

/// The point of a member at this place of the torus. It is linear in the strength. Bumps all over the surface
/// distinguish each place from its neighbours, and no motion maps a member onto itself.
inline Vec3 on_member(const Vec2& turns, double strength) {
  const double u = 2 * std::numbers::pi * turns.x(), v = 2 * std::numbers::pi * turns.y();
  const double knobs = 1.2 * std::sin(5 * u + 1) * std::cos(3 * v) + 0.8 * std::cos(7 * u - 2 * v);
  Vec3 p = on_torus(turns, 20, 8 + strength * knobs);
  p.x() *= 1.5;
  return p + Vec3(4 * std::cos(2 * u), 3 * std::sin(3 * u), 6 * strength * std::exp(std::cos(u - 0.7) - 1));
}

inline MappedSurface member_surface(double strength, int points) {
  return mapped_surface("knobbly torus", rectangular_lattice(25, 8), points,
                        [=](const Vec2& t) { return on_member(t, strength); });
}

inline std::vector<Vec3> on_member(const std::vector<Vec2>& turns, double strength) {
  std::vector<Vec3> points;
  points.reserve(turns.size());
  for (const Vec2& t : turns) points.push_back(on_member(t, strength));
  return points;
}

/// The strengths of the training shapes. Their mean is the member with strength 1.
inline const std::vector<double> training_strengths{0.7, 0.9, 1.1, 1.3};

/// A member as a new surface, with other triangles and another order of vertices.
inline Mesh new_member(double strength) {
  return build_mesh(renumbered(member_surface(strength, 3000).mesh.soup(), 5));
}

}  // namespace foramen::testing
