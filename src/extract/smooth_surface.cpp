#include "extract/smooth_surface.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "spatial/self_intersections.hpp"

namespace foramen::extract {
namespace {

class Smoother {
 public:
  Smoother(const TriangleSoup& start, const Vec3& spacing, double bound)
      : start_(start), mesh_(build_mesh(start)), spacing_(spacing), bound_(bound), points_(start.points) {
    neighbours_.reserve(points_.size());
    for (const VertexId v : mesh_.vertices()) {
      std::vector<int> around;
      for (const HalfedgeId h : mesh_.fan(v)) around.push_back(mesh_.to(h).index);
      neighbours_.push_back(std::move(around));
    }
  }

  // One step of gradient descent on sum_i |u_i|^2, where u = U x with the umbrella operator U. U is used in
  // place of its transpose, which is nearly the same because vertices have similar valences. U^2 has
  // eigenvalues up to 4, so no mode grows with a step below 1/2.
  void descend() {
    constexpr double step = 0.45;
    const std::vector<Vec3> bend = umbrellas(umbrellas(points_));
    for (std::size_t i = 0; i < points_.size(); ++i) points_[i] -= step * bend[i];
    put_back();
  }

  // Moves the surface along its normals until it encloses `volume`, as far as the bound of displacements
  // allows.
  void reach_volume(double volume) {
    constexpr int most_steps = 20;
    constexpr double accepted = 1e-5;
    for (int k = 0; k < most_steps; ++k) {
      const Mesh now = mesh_.with_positions(points_);
      const double missing = volume - signed_volume(now);
      if (std::abs(missing) <= accepted * volume) return;
      const double distance = missing / total_area(now);
      const auto normals = vertex_normals(now);
      for (const VertexId v : now.vertices()) points_[v.index] += distance * normals[v];
      put_back();
    }
  }

  // Removes self-intersections. As long as there are any, the displacements of the vertices of intersecting
  // triangles and of their neighbours are halved, and after several halvings set to zero. This terminates,
  // because the initial surface has no self-intersections. Returns the number of vertices that were moved
  // back.
  int part() {
    std::vector<char> restrained(points_.size(), 0);
    constexpr int halvings = 6;
    for (int k = 0;; ++k) {
      const auto pairs = self_intersections(TriangleTree(mesh_.with_positions(points_)));
      if (pairs.empty()) break;
      std::vector<char> now(points_.size(), 0);
      for (const auto& [a, b] : pairs)
        for (const FaceId f : {a, b})
          for (const VertexId v : mesh_.corners(f)) {
            now[v.index] = 1;
            for (const int n : neighbours_[v.index]) now[n] = 1;
          }
      bool moved = false;
      for (std::size_t i = 0; i < points_.size(); ++i) {
        if (now[i] == 0) continue;
        restrained[i] = 1;
        moved = moved || points_[i] != start_.points[i];
        points_[i] = k < halvings ? Vec3(0.5 * (points_[i] + start_.points[i])) : start_.points[i];
      }
      FORAMEN_ASSERT(moved);
    }
    return static_cast<int>(std::count(restrained.begin(), restrained.end(), 1));
  }

  std::vector<Vec3> take() { return std::move(points_); }

 private:
  std::vector<Vec3> umbrellas(const std::vector<Vec3>& values) const {
    std::vector<Vec3> result(values.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      Vec3 sum = Vec3::Zero();
      for (const int n : neighbours_[i]) sum += values[n];
      result[i] = sum / static_cast<double>(neighbours_[i].size()) - values[i];
    }
    return result;
  }
  void put_back() {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Vec3 way = points_[i] - start_.points[i];
      const double voxels = way.cwiseQuotient(spacing_).norm();
      if (voxels > bound_) points_[i] = start_.points[i] + bound_ / voxels * way;
    }
  }

  const TriangleSoup& start_;
  Mesh mesh_;
  Vec3 spacing_;
  double bound_;
  std::vector<Vec3> points_;
  std::vector<std::vector<int>> neighbours_;
};

}  // namespace

SmoothedSurface smooth_surface(const TriangleSoup& start, const Vec3& spacing, double volume, int rounds,
                               double bound) {
  Smoother smoother(start, spacing, bound);
  for (int k = 0; k < rounds; ++k) smoother.descend();
  if (rounds > 0) smoother.reach_volume(volume);
  SmoothedSurface result;
  result.restrained = smoother.part();
  result.points = smoother.take();
  return result;
}

}  // namespace foramen::extract
