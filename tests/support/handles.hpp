#pragma once
/// \file
/// Surfaces with bridges and tunnels at known places, for tests.

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "support/meshes.hpp"

namespace foramen::testing {

/// A grid torus (see torus_soup()) to which bridges and tunnels can be added. Each joins two removed quads.
class TorusWithHandles {
 public:
  /// \param flatness  factor for the height of the torus
  TorusWithHandles(int around, int tube, double flatness = 1)
      : tube_(tube), around_(around), soup(torus_soup(around, tube)) {
    for (Vec3& p : soup.points) p.z() *= flatness;
  }

  /// A tunnel from the quad (i, j) of the upper side straight down to its mirror image. \pre j between 0 and
  /// tube / 2
  void drill(int i, int j, int rings = 3) {
    const std::vector<int> top = quad(i, j),
                           bottom{id(i, -j), id(i + 1, -j), id(i + 1, -j - 1), id(i, -j - 1)};
    join(top, bottom, rings,
         [](const Vec3& from, const Vec3& to, double t) -> Vec3 { return from + t * (to - from); });
  }

  /// A bridge above the torus, in half circles, from the quad (i, j) to its mirror image (k, j), k > i.
  void bridge(int i, int k, int j, int rings = 12) {
    const std::vector<int> from = quad(i, j), to{id(k + 1, j), id(k, j), id(k, j + 1), id(k + 1, j + 1)};
    join(from, to, rings, [](const Vec3& a, const Vec3& b, double t) -> Vec3 {
      const Vec3 half = (a - b) / 2;
      return (a + b) / 2 + std::cos(std::numbers::pi * t) * half +
             std::sin(std::numbers::pi * t) * half.norm() * Vec3::UnitZ();
    });
  }

  /// Moves the points at random by about this distance, so that no two loops have the same length.
  void shake(double size_mm, std::uint64_t seed) {
    Rng rng(seed);
    for (Vec3& p : soup.points) p += size_mm * Vec3(rng.normal(), rng.normal(), rng.normal());
  }

  int tube_, around_;
  TriangleSoup soup;

 private:
  int id(int i, int j) const {
    return ((i % around_ + around_) % around_) * tube_ + (j % tube_ + tube_) % tube_;
  }
  // The corners of a quad, counter-clockwise seen from outside.
  std::vector<int> quad(int i, int j) const {
    return {id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)};
  }

  void take_out(const std::vector<int>& corners) {
    std::erase_if(soup.triangles, [&](const std::array<int, 3>& t) {
      int inside = 0;
      for (int corner : t)
        for (int c : corners) inside += corner == c ? 1 : 0;
      return inside == 3;
    });
  }

  void join(const std::vector<int>& first, const std::vector<int>& last, int rings,
            const std::function<Vec3(const Vec3&, const Vec3&, double)>& between) {
    take_out(first);
    take_out(last);
    std::vector<int> ring = first;
    for (int r = 1; r <= rings; ++r) {
      std::vector<int> next = last;
      if (r < rings)
        for (std::size_t k = 0; k < first.size(); ++k) {
          const Vec3 a = soup.points[first[k]], b = soup.points[last[k]];
          next[k] = static_cast<int>(soup.points.size());
          soup.points.push_back(between(a, b, static_cast<double>(r) / rings));
        }
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const std::size_t l = (k + 1) % ring.size();
        soup.triangles.push_back({ring[k], ring[l], next[l]});
        soup.triangles.push_back({ring[k], next[l], next[k]});
      }
      ring = next;
    }
  }
};

}  // namespace foramen::testing
