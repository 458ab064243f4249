#include "extract/cube_triangles.hpp"

#include <optional>
#include <utility>

#include "foramen/core/error.hpp"

namespace foramen::extract {
namespace {

using Triangles = std::vector<std::array<int, 3>>;
using Loop = std::vector<int>;  // indices of cube edges
constexpr int edges = 12, no_edge = -1;
constexpr unsigned configurations = 256;

int edge_between(int corner, int axis) {
  const auto bit = [&](int a) { return corner >> (a % 3) & 1; };
  return 4 * axis + bit(axis + 1) + 2 * bit(axis + 2);
}

// The corners and edges of one face, counter-clockwise seen from outside the cube.
struct FaceWalk {
  std::array<int, 4> corner, edge;  // edge[k] runs from corner[k] to corner[k + 1]
};

FaceWalk face_walk(int axis, int side) {
  const int u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3, base = side << axis;
  FaceWalk walk{};
  walk.corner = side == 1 ? std::array{base, base + u, base + u + v, base + v}
                          : std::array{base, base + v, base + u + v, base + u};
  for (std::size_t k = 0; k < 4; ++k) {
    const int from = walk.corner[k], to = walk.corner[(k + 1) % 4], low = from < to ? from : to;
    const int step = from ^ to, along = step == 1 ? 0 : step == 2 ? 1 : 2;
    walk.edge[k] = edge_between(low, along);
  }
  return walk;
}

bool share_face(int a, int b) {
  const CubeEdge p = cube_edge(a), q = cube_edge(b);
  for (int axis = 0; axis < 3; ++axis)
    if (p.axis != axis && q.axis != axis && p.from[axis] == q.from[axis]) return true;
  return false;
}

Vec3 middle(int edge) {
  const CubeEdge e = cube_edge(edge);
  Vec3 p(e.from[0], e.from[1], e.from[2]);
  p[e.axis] = 0.5;
  return p;
}

// For each cut edge, the next cut edge of the loop. On every face, an edge at which the walk enters the
// inside is joined with the preceding edge at which it left the inside, so the segment goes around the
// outside corners between them.
std::array<int, edges> successors(unsigned inside) {
  std::array<int, edges> next{};
  next.fill(no_edge);
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side) {
      const FaceWalk walk = face_walk(axis, side);
      const auto in = [&](std::size_t k) { return (inside >> walk.corner[k % 4] & 1U) != 0; };
      for (std::size_t k = 0; k < 4; ++k) {
        if (in(k) || !in(k + 1)) continue;
        std::size_t out = k + 3;
        while (!(in(out) && !in(out + 1))) out += 3;
        next[walk.edge[k]] = walk.edge[out % 4];
      }
    }
  return next;
}

// The triangulation of the part first..last of a loop with the least sum of squared diagonals, measured
// between midpoints of edges. No diagonal may lie in a face of the cube; nullopt if there is no such
// triangulation.
struct Triangulation {
  double cost = 0;
  Triangles triangles;
};

std::optional<Triangulation> triangulate(const Loop& loop, std::size_t first, std::size_t last) {
  if (last < first + 2) return Triangulation{};
  const bool is_side = first == 0 && last + 1 == loop.size();
  if (!is_side && share_face(loop[first], loop[last])) return std::nullopt;
  std::optional<Triangulation> best;
  for (std::size_t apex = first + 1; apex < last; ++apex) {
    auto left = triangulate(loop, first, apex), right = triangulate(loop, apex, last);
    if (!left || !right) continue;
    const double diagonal = is_side ? 0 : (middle(loop[first]) - middle(loop[last])).squaredNorm();
    const double cost = left->cost + right->cost + diagonal;
    if (best && best->cost <= cost) continue;
    left->cost = cost;
    left->triangles.insert(left->triangles.end(), right->triangles.begin(), right->triangles.end());
    left->triangles.push_back({loop[first], loop[apex], loop[last]});
    best = std::move(left);
  }
  return best;
}

Triangles triangles_of(unsigned inside) {
  auto next = successors(inside);
  Triangles all;
  for (int start = 0; start < edges; ++start) {
    Loop loop;
    for (int e = start; next[e] != no_edge;) {
      loop.push_back(e);
      const int after = next[e];
      next[e] = no_edge;
      e = after;
    }
    if (loop.empty()) continue;
    const auto found = triangulate(loop, 0, loop.size() - 1);
    FORAMEN_ASSERT(found.has_value());
    all.insert(all.end(), found->triangles.begin(), found->triangles.end());
  }
  return all;
}

}  // namespace

CubeEdge cube_edge(int edge) {
  CubeEdge e{edge / 4, {}};
  e.from[(e.axis + 1) % 3] = edge & 1;
  e.from[(e.axis + 2) % 3] = edge >> 1 & 1;
  return e;
}

const Triangles& cube_triangles(unsigned inside, EdgeContact contact) {
  using Table = std::array<Triangles, configurations>;
  static const Table joined = [] {
    Table all;
    for (unsigned c = 0; c < all.size(); ++c) all[c] = triangles_of(c);
    return all;
  }();
  // The tables of `apart` are those of `joined` with inside and outside exchanged.
  static const Table apart = [] {
    Table all;
    for (unsigned c = 0; c < all.size(); ++c)
      for (const auto& t : joined[configurations - 1 - c]) all[c].push_back({t[0], t[2], t[1]});
    return all;
  }();
  return contact == EdgeContact::joined ? joined[inside] : apart[inside];
}

}  // namespace foramen::extract
