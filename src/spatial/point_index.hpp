#pragma once
/// \file
/// Nearest points by kd-tree.

#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A point found by a search: its index and its squared distance in the metric of the search.
struct NearPoint {
  int index = -1;
  double squared_distance = 0;
  double distance() const { return std::sqrt(squared_distance); }
};

/// Nearest points in space. Of points at equal distances the one of smallest index comes first.
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

/// Weight of normals for vertebrae: mm per unit of normal difference. It keeps a search on one side of the
/// thin walls of a vertebra.
inline constexpr double vertebra_normal_weight_mm = 8.0;

/// Nearest points by position and normal, in the metric distance^2 = |p - q|^2 + weight^2 |n - m|^2 of a
/// six-dimensional search.
class OrientedPointIndex {
 public:
  /// \param normal_weight  mm per unit of normal difference, e.g. vertebra_normal_weight_mm
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
