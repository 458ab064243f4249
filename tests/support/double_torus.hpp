#pragma once
/// \file
/// Surfaces of genus 2, for tests and benchmarks.

#include <cstdint>

#include "support/meshes.hpp"

namespace foramen::testing {

/// A closed surface of genus 2, wound outward, with 2 * around * tube vertices. It consists of two tori
/// beside each other along x, which are mirror images of each other. One quad at the outer rim of each is
/// removed, and the two openings are joined by four quads.
inline TriangleSoup genus2_soup(int around, int tube) {
  constexpr double major_mm = 20, minor_mm = 8, gap_mm = 2;
  const TriangleSoup torus = torus_soup(around, tube, major_mm, minor_mm);
  const int count = static_cast<int>(torus.points.size());
  TriangleSoup soup;
  const Vec3 shift = Vec3::UnitX() * (major_mm + minor_mm + gap_mm / 2);
  for (const Vec3& p : torus.points) soup.points.emplace_back(p - shift);
  for (const Vec3& p : torus.points) soup.points.emplace_back(shift.x() - p.x(), p.y(), p.z());
  for (std::size_t f = 2; f < torus.triangles.size(); ++f) {  // the first two are the quad (0, 0) at the rim
    const auto& t = torus.triangles[f];
    soup.triangles.push_back(t);
    soup.triangles.push_back({t[0] + count, t[2] + count, t[1] + count});
  }
  const int rim[] = {0, tube, tube + 1, 1};  // counter-clockwise seen from outside
  for (int k = 0; k < 4; ++k) {
    const int a = rim[k], b = rim[(k + 1) % 4];
    soup.triangles.push_back({a, b, b + count});
    soup.triangles.push_back({a, b + count, a + count});
  }
  return soup;
}

/// The surface of genus2_soup() with noise, so that no two loops have the same length.
inline TriangleSoup bumpy_genus2_soup(int around, int tube, std::uint64_t seed) {
  TriangleSoup soup = genus2_soup(around, tube);
  Rng rng(seed);
  for (Vec3& p : soup.points) p += 0.2 * Vec3(rng.normal(), rng.normal(), rng.normal());
  return soup;
}

}  // namespace foramen::testing
