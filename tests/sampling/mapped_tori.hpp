#pragma once
/// \file
/// Surfaces of genus 1 with a known torus map: a grid of the torus is mapped to space by a formula.

#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "sampling/torus_grid.hpp"

namespace foramen::testing {

struct MappedSurface {
  std::string name;
  Mesh mesh;
  TorusMap map;
};

/// A grid of about `points` points of the lattice, each at shape(turns).
inline MappedSurface mapped_surface(std::string name, const Lattice& lattice, int points,
                                    const std::function<Vec3(const Vec2&)>& shape) {
  const TorusGrid grid = make_torus_grid(lattice, points);
  TriangleSoup soup;
  for (const Vec2& t : grid.turns) soup.points.push_back(shape(t));
  soup.triangles = grid.triangles;
  return {std::move(name), build_mesh(std::move(soup)), {lattice, VertexMap<Vec2>(grid.turns), grid.jumps}};
}

/// Periods of the given lengths at a right angle, scaled to area 1.
inline Lattice rectangular_lattice(double along, double across) {
  return Vec2(std::sqrt(along / across), std::sqrt(across / along)).asDiagonal();
}

inline Vec3 on_torus(const Vec2& turns, double major_mm, double minor_mm) {
  const double u = 2 * std::numbers::pi * turns.x(), v = 2 * std::numbers::pi * turns.y();
  const double r = major_mm + minor_mm * std::cos(v);
  return {r * std::cos(u), r * std::sin(u), minor_mm * std::sin(v)};
}

/// A torus of revolution, wound outward.
inline MappedSurface torus(int points, double major_mm = 20, double minor_mm = 8) {
  return mapped_surface("torus", rectangular_lattice(major_mm, minor_mm), points,
                        [=](const Vec2& t) { return on_torus(t, major_mm, minor_mm); });
}

/// A torus with waves of different lengths.
inline MappedSurface wavy_torus(int points) {
  return mapped_surface("wavy torus", rectangular_lattice(20, 8), points, [](const Vec2& t) {
    const double u = 2 * std::numbers::pi * t.x(), v = 2 * std::numbers::pi * t.y();
    return on_torus(t, 20 + 2 * std::cos(3 * u), 8 + 1.5 * std::sin(2 * u + v) + 0.6 * std::cos(5 * v));
  });
}

/// A torus with `count` thin spikes along the outer equator.
inline MappedSurface spiky_torus(int points, int count, double height_mm, double width_turns) {
  return mapped_surface("spiky torus", rectangular_lattice(20, 8), points, [=](const Vec2& t) {
    double height = 0;
    for (int k = 0; k < count; ++k) {
      const double x = std::remainder(t.x() - (k + 0.5) / count, 1.0) / width_turns;
      const double y = std::remainder(t.y(), 1.0) * 8 / 20 / width_turns;
      height += height_mm * std::exp(-(x * x + y * y) / 2);
    }
    return on_torus(t, 20, 8 + height);
  });
}

}  // namespace foramen::testing
