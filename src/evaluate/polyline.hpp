#pragma once
/// \file
/// Polylines by arc length.

#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::detail {

/// A chain of straight segments; a closed one ends with a segment back to its first point.
class Polyline {
 public:
  /// \pre at least one point
  Polyline(std::span<const Vec3> points, bool closed);

  double length() const { return arc_.back(); }
  /// The point at this share of the length from the start, 0 .. 1.
  Vec3 at(double share) const;
  /// Evenly spaced points by arc length: from the start to the end of an open chain, once around a closed
  /// one.
  std::vector<Vec3> resampled(int count) const;
  /// The centroid of the segments by length.
  Vec3 centroid() const;
  /// The distance of a point to the closest segment.
  double distance(const Vec3& p) const;

 private:
  std::vector<Vec3> points_;  // a closed chain repeats its first point
  std::vector<double> arc_;   // length from the start to each point
  bool closed_;
};

/// The average of the two mean distances of `samples` evenly spaced points of each chain to the other chain.
double mean_distance(const Polyline& a, const Polyline& b, int samples);

}  // namespace foramen::detail
