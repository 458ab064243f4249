#pragma once
/// \file
/// The closest point on one triangle. It is the innermost loop of every surface query, hence inline.

#include <algorithm>
#include <array>

#include "foramen/core/mesh.hpp"

namespace foramen::detail {

/// The point a + v (b - a) + w (c - a) of the triangle a, b, c, with v, w >= 0 and v + w <= 1 up to rounding.
struct TrianglePoint {
  double v = 0, w = 0;
  double squared_distance = 0;
};

inline Vec3 point_of(const std::array<Vec3, 3>& t, double v, double w) {
  return t[0] + v * (t[1] - t[0]) + w * (t[2] - t[0]);
}

inline TrianglePoint at(const std::array<Vec3, 3>& t, const Vec3& query, double v, double w) {
  const Vec3 d = query - point_of(t, v, w);
  return {v, w, d[0] * d[0] + d[1] * d[1] + d[2] * d[2]};
}

/// Whether a height of the triangle is so small relative to its longest side that the region tests lose
/// digits.
bool is_sliver(const std::array<Vec3, 3>& t);
/// Slower than closest_on_regular(), but accurate for every triangle including degenerate ones.
TrianglePoint closest_on_sliver(const std::array<Vec3, 3>& t, const Vec3& query);

/// By the Voronoi regions of corners, edges and face (Ericson, Real-Time Collision Detection, 5.1.5).
/// \pre not a sliver.
inline TrianglePoint closest_on_regular(const std::array<Vec3, 3>& t, const Vec3& query) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0], ap = query - t[0];
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return at(t, query, 0, 0);
  const Vec3 bp = query - t[1];
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return at(t, query, 1, 0);
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return at(t, query, d1 / (d1 - d3), 0);
  const Vec3 cp = query - t[2];
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return at(t, query, 0, 1);
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return at(t, query, 0, d2 / (d2 - d6));
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return at(t, query, 1 - w, w);
  }
  const double scale = 1 / (va + vb + vc);
  return at(t, query, vb * scale, vc * scale);
}

}  // namespace foramen::detail
