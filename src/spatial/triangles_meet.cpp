#include "spatial/triangles_meet.hpp"

#include <algorithm>
#include <optional>

#include "spatial/orientation.hpp"

namespace foramen {
namespace {

using detail::orientation;
using Triangle3 = std::array<Vec3, 3>;
using Triangle2 = std::array<Vec2, 3>;

constexpr int axes = 3;

Vec2 without(int axis, const Vec3& p) { return {p[(axis + 1) % axes], p[(axis + 2) % axes]}; }

Triangle2 without(int axis, const Triangle3& t) {
  return {without(axis, t[0]), without(axis, t[1]), without(axis, t[2])};
}

int turn(const Triangle2& t) { return orientation(t[0], t[1], t[2]); }

/// A coordinate axis along which the plane of the triangle projects one to one; nullopt if the triangle has
/// zero area.
std::optional<int> dispensable_axis(const Triangle3& t) {
  for (int axis = 0; axis < axes; ++axis)
    if (turn(without(axis, t)) != 0) return axis;
  return std::nullopt;
}

int side(const Triangle3& t, const Vec3& p) { return orientation(t[0], t[1], t[2], p); }

bool same_strict_side(int a, int b) { return a * b > 0; }

bool contains(const Triangle2& t, const Vec2& p) {
  const int a = orientation(t[0], t[1], p), b = orientation(t[1], t[2], p), c = orientation(t[2], t[0], p);
  return std::min({a, b, c}) >= 0 || std::max({a, b, c}) <= 0;
}

struct Segment2 {
  Vec2 from, to;
};

bool boxes_meet(const Segment2& a, const Segment2& b) {
  const Eigen::Array2d low_a = a.from.cwiseMin(a.to), high_a = a.from.cwiseMax(a.to);
  const Eigen::Array2d low_b = b.from.cwiseMin(b.to), high_b = b.from.cwiseMax(b.to);
  return (low_a <= high_b).all() && (low_b <= high_a).all();
}

bool meet(const Segment2& a, const Segment2& b) {
  const int from_b = orientation(a.from, a.to, b.from), to_b = orientation(a.from, a.to, b.to);
  const int from_a = orientation(b.from, b.to, a.from), to_a = orientation(b.from, b.to, a.to);
  if (same_strict_side(from_b, to_b) || same_strict_side(from_a, to_a)) return false;
  const bool on_one_line = from_b == 0 && to_b == 0;
  return !on_one_line || boxes_meet(a, b);
}

bool meet(const Segment2& s, const Triangle2& t) {
  return contains(t, s.from) || meet(s, Segment2{t[0], t[1]}) || meet(s, Segment2{t[1], t[2]}) ||
         meet(s, Segment2{t[2], t[0]});
}

struct Segment3 {
  Vec3 from, to;
  int from_side, to_side;  // sides of the plane of the triangle on which the ends lie
};

/// \pre the triangle has area, the ends of the segment differ
bool meet(const Segment3& s, const Triangle3& t) {
  if (same_strict_side(s.from_side, s.to_side)) return false;
  if (s.from_side == 0 && s.to_side == 0) {
    const int axis = dispensable_axis(t).value();
    return meet(Segment2{without(axis, s.from), without(axis, s.to)}, without(axis, t));
  }
  // The segment crosses the plane. The crossing lies in the triangle if the line passes all three edges on
  // the same side.
  const int a = orientation(s.from, s.to, t[0], t[1]), b = orientation(s.from, s.to, t[1], t[2]);
  if (same_strict_side(a, -b)) return false;
  const int c = orientation(s.from, s.to, t[2], t[0]);
  return !same_strict_side(a, -c) && !same_strict_side(b, -c);
}

using Sides = std::array<int, 3>;

Sides sides(const Triangle3& plane, const Triangle3& corners) {
  return {side(plane, corners[0]), side(plane, corners[1]), side(plane, corners[2])};
}

bool apart(const Sides& s) { return same_strict_side(s[0], s[1]) && same_strict_side(s[1], s[2]); }

/// \param of_edges  on which sides of the plane of `face` the corners of `edges` lie
bool any_edge_meets(const Triangle3& edges, const Sides& of_edges, const Triangle3& face) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    if (meet(Segment3{edges[i], edges[j], of_edges[i], of_edges[j]}, face)) return true;
  }
  return false;
}

/// For triangles without a common vertex. If they have a common point, an edge of one of them meets the
/// other.
bool have_common_point(const Triangle3& a, const Triangle3& b) {
  const Sides of_b = sides(a, b);
  if (apart(of_b)) return false;
  const Sides of_a = sides(b, a);
  return !apart(of_a) && (any_edge_meets(a, of_a, b) || any_edge_meets(b, of_b, a));
}

/// For triangles that share corner 0. A ray from this corner that runs in both triangles leaves one of them
/// first, through the opposite edge, so that edge meets the other triangle.
bool meet_beyond_vertex(const Triangle3& a, const Triangle3& b) {
  const Segment3 opposite_a{a[1], a[2], side(b, a[1]), side(b, a[2])};
  if (same_strict_side(opposite_a.from_side, opposite_a.to_side)) return false;
  const Segment3 opposite_b{b[1], b[2], side(a, b[1]), side(a, b[2])};
  return meet(opposite_a, b) || meet(opposite_b, a);
}

/// For triangles that share the edge from corner 1 to corner 2 of `a`; `other` is the third corner of the
/// second triangle.
bool fold_onto_each_other(const Triangle3& a, const Vec3& other) {
  if (side(a, other) != 0) return false;
  const int axis = dispensable_axis(a).value();
  const Triangle2 here = without(axis, a);
  return turn(here) == turn({without(axis, other), here[1], here[2]});
}

/// The vertices that two triangles share.
struct SharedCorners {
  int count = 0;
  int in_a = 0, in_b = 0;  // sums of the corner numbers of the shared vertices
};

SharedCorners shared_corners(const std::array<VertexId, 3>& a, const std::array<VertexId, 3>& b) {
  SharedCorners shared;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (a[i] == b[j]) {
        ++shared.count;
        shared.in_a += i;
        shared.in_b += j;
      }
  return shared;
}

Triangle3 beginning_at(int corner, const Triangle3& t) {
  const std::size_t c = corner;
  return {t[c], t[(c + 1) % 3], t[(c + 2) % 3]};
}

}  // namespace

bool has_area(const std::array<Vec3, 3>& triangle) { return dispensable_axis(triangle).has_value(); }

bool triangles_meet(const NumberedTriangle& a, const NumberedTriangle& b) {
  constexpr int all_corners = 0 + 1 + 2;
  const SharedCorners shared = shared_corners(a.corners, b.corners);
  switch (shared.count) {
    case 0:
      return have_common_point(a.points, b.points);
    case 1:
      return meet_beyond_vertex(beginning_at(shared.in_a, a.points), beginning_at(shared.in_b, b.points));
    case 2:
      return fold_onto_each_other(beginning_at(all_corners - shared.in_a, a.points),
                                  b.points[all_corners - shared.in_b]);
    default:
      return true;
  }
}

}  // namespace foramen
