#include "spatial/triangle_closest.hpp"

#include <cmath>
#include <limits>

#include <Eigen/Geometry>

namespace foramen::detail {
namespace {

// Ratio of height to longest side below which a triangle is treated as a sliver. At this ratio the region
// tests still have 12 correct digits. Below edge_like_height the two-dimensional solution for slivers is
// inaccurate as well, but there some edge is as close as the interior to that relative precision, so only the
// edges are searched.
constexpr double sliver_height = 1e-2;
constexpr double edge_like_height = 1e-10;

double sq(double x) { return x * x; }

TrianglePoint nearer_of(const TrianglePoint& a, const TrianglePoint& b) {
  return b.squared_distance < a.squared_distance ? b : a;
}

// Parameter of the closest point on the segment p .. q; 0 if the segment has length zero.
double along_segment(const Vec3& p, const Vec3& q, const Vec3& query) {
  const Vec3 side = q - p;
  const double length2 = side.squaredNorm();
  return length2 > 0 ? std::clamp(side.dot(query - p) / length2, 0.0, 1.0) : 0.0;
}

// The projection of the query onto the plane of the triangle, if it falls inside. It is computed in an
// orthogonal frame along the longest side, which is well conditioned even if the Gram matrix of two sides is
// not.
TrianglePoint inside(const std::array<Vec3, 3>& t, const Vec3& query) {
  std::size_t k = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if ((t[(i + 1) % 3] - t[i]).squaredNorm() > (t[(k + 1) % 3] - t[k]).squaredNorm()) k = i;
  TrianglePoint none;
  none.squared_distance = std::numeric_limits<double>::infinity();
  const Vec3& origin = t[k];
  const Vec3 side = t[(k + 1) % 3] - origin, other = t[(k + 2) % 3] - origin;
  const double length2 = side.squaredNorm();
  if (!(length2 > 0)) return none;
  const double foot = side.dot(other) / length2;
  const Vec3 height = other - foot * side;
  const double height2 = height.squaredNorm();
  if (height2 <= sq(edge_like_height) * length2) return none;
  const Vec3 r = query - origin;
  std::array<double, 3> barycentric{};
  barycentric[(k + 2) % 3] = height.dot(r) / height2;
  barycentric[(k + 1) % 3] = side.dot(r) / length2 - foot * barycentric[(k + 2) % 3];
  barycentric[k] = 1 - barycentric[(k + 1) % 3] - barycentric[(k + 2) % 3];
  if (barycentric[0] < 0 || barycentric[1] < 0 || barycentric[2] < 0) return none;
  return at(t, query, barycentric[1], barycentric[2]);
}

}  // namespace

bool is_sliver(const std::array<Vec3, 3>& t) {
  const Vec3 ab = t[1] - t[0], ac = t[2] - t[0];
  const double longest2 = std::max({ab.squaredNorm(), ac.squaredNorm(), (t[2] - t[1]).squaredNorm()});
  return ab.cross(ac).squaredNorm() <= sq(sliver_height) * sq(longest2);  // (height / longest)^2 <= ratio^2
}

TrianglePoint closest_on_sliver(const std::array<Vec3, 3>& t, const Vec3& query) {
  const TrianglePoint ab = at(t, query, along_segment(t[0], t[1], query), 0);
  const TrianglePoint ac = at(t, query, 0, along_segment(t[0], t[2], query));
  const double s = along_segment(t[1], t[2], query);
  const TrianglePoint bc = at(t, query, 1 - s, s);
  return nearer_of(nearer_of(nearer_of(ab, ac), bc), inside(t, query));
}

}  // namespace foramen::detail
