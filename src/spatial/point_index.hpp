#pragma once
/// \file
/// Nearest points by kd-tree.

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

struct NearPoint {
  int index = -1;
  double squared_distance = 0;
  double distance() const { return std::sqrt(squared_distance); }
};

/// Nearest points in space; equal distances: the smaller index.
class PointIndex {
 public:
  explicit PointIndex(std::span<const Vec3> points);
  ~PointIndex();
  PointIndex(PointIndex&&) noexcept;
  PointIndex& operator=(PointIndex&&) noexcept;
  NearPoint nearest(const Vec3& query) const;
  /// The `count` nearest, nearest first (fewer if there are fewer points).
  std::vector<NearPoint> nearest(const Vec3& query, int count) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// mm per unit of normal difference: keeps a search on its own side of a vertebra's thin walls.
inline constexpr double vertebra_normal_weight_mm = 8.0;

/// Nearest points by position and normal together: distance^2 = |p - q|^2 + weight^2 |n - m|^2 (a 6-D
/// search).
class OrientedPointIndex {
 public:
  /// \param normal_weight  mm per unit of normal difference; 8 mm serves vertebrae
  OrientedPointIndex(std::span<const Vec3> points, std::span<const Vec3> normals, double normal_weight);
  ~OrientedPointIndex();
  OrientedPointIndex(OrientedPointIndex&&) noexcept;
  OrientedPointIndex& operator=(OrientedPointIndex&&) noexcept;
  NearPoint nearest(const Vec3& query, const Vec3& normal) const;
  std::vector<NearPoint> nearest(const Vec3& query, const Vec3& normal, int count) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace foramen
