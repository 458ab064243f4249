#pragma once
/// \file
/// From torus coordinates to points on a shape: the inverse of a torus map.

#include <span>
#include <vector>

#include "foramen/core/surface_point.hpp"
#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// Finds the triangle of a torus map that contains a point. Exact partition: every point has exactly one answer,
/// whatever translate of it is asked for.
class TorusLocator {
 public:
  TorusLocator(const Mesh& mesh, const TorusMap& map);
  /// \param turns  any representative
  SurfacePoint locate(const Vec2& turns) const;
  std::vector<SurfacePoint> locate(std::span<const Vec2> turns) const;

 private:
  Mesh mesh_;
  TorusMap map_;
  int cells_ = 1;                          // cells_ x cells_ buckets over the unit square of turns
  std::vector<std::vector<int>> buckets_;  // faces whose box touches the bucket (with the translate it needs)
};

}  // namespace foramen
