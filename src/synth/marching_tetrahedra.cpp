#include "synth/marching_tetrahedra.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <unordered_map>

namespace foramen::synth {
namespace {

// Integer coordinates of a lattice point in half-steps of the cube side: cube corners have even coordinates
// and cube centres odd ones.
using LatticePoint = std::array<int, 3>;

class Lattice {
 public:
  Lattice(const ImplicitFunction& function, const BoundingBox& bounds, double spacing,
          const RigidTransform& pose)
      : function_(function), bounds_(bounds), half_step_(spacing / 2), pose_(pose) {
    const RigidTransform inverse = pose.inverse();
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (int corner = 0; corner < 8; ++corner) {
      Vec3 p;
      for (int k = 0; k < 3; ++k) p[k] = (corner >> k & 1) != 0 ? bounds.high[k] : bounds.low[k];
      low = low.cwiseMin(inverse * p);
      high = high.cwiseMax(inverse * p);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      // One cube of margin, so that the outermost points are outside the bounds.
      first_[k] = static_cast<int>(std::floor(low[static_cast<int>(k)] / spacing)) - 1;
      cubes_[k] = static_cast<int>(std::ceil(high[static_cast<int>(k)] / spacing)) + 1 - first_[k];
    }
    find_insides();
  }

  std::array<int, 3> cubes() const { return cubes_; }
  Vec3 position(const LatticePoint& p) const {
    Vec3 local;
    for (std::size_t k = 0; k < 3; ++k)
      local[static_cast<int>(k)] = half_step_ * static_cast<double>(2 * first_[k] + p[k]);
    return pose_ * local;
  }
  bool inside(const LatticePoint& p) const { return inside_[index(p)] != 0; }
  /// A unique index for every lattice point; corners come before centres.
  std::int64_t index(const LatticePoint& p) const {
    const std::int64_t within =
        (std::int64_t{p[2] / 2} * (cubes_[1] + 1) + p[1] / 2) * (cubes_[0] + 1) + p[0] / 2;
    return (p[0] % 2 != 0 ? layer() : 0) + within;
  }
  double value(const LatticePoint& p) const {
    const Vec3 x = position(p);
    return in_bounds(x) ? function_(x).value : 1.0;
  }

 private:
  std::int64_t layer() const { return std::int64_t{cubes_[0] + 1} * (cubes_[1] + 1) * (cubes_[2] + 1); }
  bool in_bounds(const Vec3& p) const {
    return (p.array() >= bounds_.low.array()).all() && (p.array() <= bounds_.high.array()).all();
  }
  void find_insides() {
    inside_.assign(2 * layer(), 0);
    for (int odd = 0; odd < 2; ++odd)
      for (int k = odd; k <= 2 * cubes_[2]; k += 2)
        for (int j = odd; j <= 2 * cubes_[1]; j += 2)
          for (int i = odd; i <= 2 * cubes_[0]; i += 2)
            if (value({i, j, k}) < 0) inside_[index({i, j, k})] = 1;
  }

  const ImplicitFunction& function_;
  BoundingBox bounds_;
  double half_step_;
  RigidTransform pose_;
  std::array<int, 3> first_{}, cubes_{};
  std::vector<char> inside_;
};

class Marcher {
 public:
  explicit Marcher(const Lattice& lattice) : lattice_(lattice) {}

  void tetrahedron(const std::array<LatticePoint, 4>& t) {
    std::vector<LatticePoint> in, out;
    for (const LatticePoint& p : t) (lattice_.inside(p) ? in : out).push_back(p);
    if (in.empty() || out.empty()) return;
    if (in.size() == 1) {
      add({cut(in[0], out[0]), cut(in[0], out[1]), cut(in[0], out[2])});
    } else if (out.size() == 1) {
      add({cut(in[0], out[0]), cut(in[1], out[0]), cut(in[2], out[0])});
    } else {
      const Cut a = cut(in[0], out[0]), b = cut(in[0], out[1]), c = cut(in[1], out[1]),
                d = cut(in[1], out[0]);
      add({a, b, c});
      add({a, c, d});
    }
  }
  TriangleSoup take() { return std::move(soup_); }

 private:
  static constexpr double least_share = 0.1;
  struct Cut {
    int vertex;
    Vec3 middle;   // midpoint of the lattice edge; triangles of midpoints are never degenerate
    Vec3 outward;  // along the lattice edge
  };

  Cut cut(const LatticePoint& in, const LatticePoint& out) {
    const Vec3 p = lattice_.position(in), q = lattice_.position(out);
    const auto [place, is_new] = vertex_of_edge_.try_emplace({lattice_.index(in), lattice_.index(out)},
                                                             static_cast<int>(soup_.points.size()));
    if (is_new) {
      const double a = lattice_.value(in), b = lattice_.value(out);
      // The vertex is kept away from the ends of the edge. Otherwise, if the surface passes through a lattice
      // point, all edges of the point would be cut at the same position.
      soup_.points.push_back(p + std::clamp(a / (a - b), least_share, 1 - least_share) * (q - p));
    }
    return {place->second, 0.5 * (p + q), q - p};
  }
  void add(const std::array<Cut, 3>& t) {
    const Vec3 normal = area_vector({t[0].middle, t[1].middle, t[2].middle});
    const bool outward = normal.dot(t[0].outward + t[1].outward + t[2].outward) > 0;
    if (outward)
      soup_.triangles.push_back({t[0].vertex, t[1].vertex, t[2].vertex});
    else
      soup_.triangles.push_back({t[0].vertex, t[2].vertex, t[1].vertex});
  }

  struct EdgeHash {
    std::size_t operator()(const std::pair<std::int64_t, std::int64_t>& e) const {
      return std::hash<std::uint64_t>{}(static_cast<std::uint64_t>(e.first) * 0x9e3779b97f4a7c1ULL ^
                                        static_cast<std::uint64_t>(e.second));
    }
  };
  const Lattice& lattice_;
  TriangleSoup soup_;
  std::unordered_map<std::pair<std::int64_t, std::int64_t>, int, EdgeHash> vertex_of_edge_;
};

// Marches the four tetrahedra around the segment between the centres of two cubes that are adjacent along an
// axis. Each tetrahedron consists of this segment and one side of the square face between the cubes.
void march_face(const Lattice& lattice, const LatticePoint& centre, std::size_t axis, Marcher& marcher) {
  LatticePoint next = centre;
  next[axis] += 2;
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  constexpr std::array<std::array<int, 2>, 4> around{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  std::array<LatticePoint, 4> corner;
  for (std::size_t m = 0; m < 4; ++m) {
    corner[m] = centre;
    corner[m][axis] += 1;
    corner[m][u] += around[m][0];
    corner[m][v] += around[m][1];
  }
  const bool first = lattice.inside(centre);
  const auto same = [&](const LatticePoint& p) { return lattice.inside(p) == first; };
  if (same(next) && std::all_of(corner.begin(), corner.end(), same)) return;
  for (std::size_t m = 0; m < 4; ++m) marcher.tetrahedron({centre, next, corner[m], corner[(m + 1) % 4]});
}

}  // namespace

TriangleSoup march_tetrahedra(const ImplicitFunction& function, const BoundingBox& bounds, double spacing_mm,
                              const RigidTransform& pose) {
  const Lattice lattice(function, bounds, spacing_mm, pose);
  const auto cubes = lattice.cubes();
  Marcher marcher(lattice);
  for (int k = 1; k < 2 * cubes[2]; k += 2)
    for (int j = 1; j < 2 * cubes[1]; j += 2)
      for (int i = 1; i < 2 * cubes[0]; i += 2) {
        const LatticePoint centre{i, j, k};
        for (std::size_t axis = 0; axis < 3; ++axis)
          if (centre[axis] + 2 < 2 * cubes[axis]) march_face(lattice, centre, axis, marcher);
      }
  return marcher.take();
}

}  // namespace foramen::synth
