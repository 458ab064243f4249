#pragma once
/// \file
/// Small surfaces with known topology, for tests and benchmarks.

#include <cmath>
#include <numbers>
#include <utility>

#include "foramen/core/mesh.hpp"
#include "foramen/core/rng.hpp"

namespace foramen::testing {

/// A torus of revolution about z: `around` quads about the axis, `tube` quads about the tube, wound outward.
inline TriangleSoup torus_soup(int around, int tube, double major_mm = 20, double minor_mm = 8) {
  TriangleSoup soup;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < tube; ++j) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / tube;
      const double r = major_mm + minor_mm * std::cos(v);
      soup.points.emplace_back(r * std::cos(u), r * std::sin(u), minor_mm * std::sin(v));
    }
  const auto id = [&](int i, int j) { return (i % around) * tube + j % tube; };
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < tube; ++j) {
      soup.triangles.push_back({id(i, j), id(i + 1, j), id(i + 1, j + 1)});
      soup.triangles.push_back({id(i, j), id(i + 1, j + 1), id(i, j + 1)});
    }
  return soup;
}

/// The same torus with its points moved by smooth bumps and noise, so that no two loops have the same length.
inline TriangleSoup bumpy_torus_soup(int around, int tube, std::uint64_t seed) {
  TriangleSoup soup = torus_soup(around, tube);
  Rng rng(seed);
  const double phase = rng.uniform(0, 6.28), size = rng.uniform(0.1, 0.25);
  for (Vec3& p : soup.points) {
    const double u = std::atan2(p.y(), p.x());
    p *= 1 + size * std::cos(2 * u + phase);
    p += 0.2 * Vec3(rng.normal(), rng.normal(), rng.normal());
  }
  return soup;
}

/// The surface with its vertices and triangles in another order.
inline TriangleSoup renumbered(const TriangleSoup& soup, std::uint64_t seed) {
  Rng rng(seed);
  const auto shuffled = [&](std::size_t count) {
    std::vector<int> order(count);
    for (std::size_t i = 0; i < count; ++i) order[i] = static_cast<int>(i);
    for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[rng.below(static_cast<int>(i))]);
    return order;
  };
  const auto vertex = shuffled(soup.points.size()), face = shuffled(soup.triangles.size());
  TriangleSoup out;
  out.points.resize(soup.points.size());
  out.triangles.resize(soup.triangles.size());
  for (std::size_t v = 0; v < vertex.size(); ++v) out.points[vertex[v]] = soup.points[v];
  for (std::size_t f = 0; f < face.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) out.triangles[face[f]][k] = vertex[soup.triangles[f][k]];
  return out;
}

}  // namespace foramen::testing
