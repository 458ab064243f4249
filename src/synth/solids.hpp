#pragma once
/// \file
/// The simple solids of which the vertebra is composed, as signed distances with gradients.

#include <algorithm>
#include <array>

#include "foramen/core/geometry.hpp"
#include "synth/jet.hpp"

namespace foramen::synth {

/// A bounding ball of a solid: distance(p) >= |p - centre| - radius.
struct Ball {
  Vec3 centre;
  double radius;
};

/// A plate: a rectangle with rounded corners in the plane of the first two axes, with a thickness along the
/// third axis and rounded edges. The distance is exact outside and on the surface.
struct Plate {
  Vec3 centre;
  Mat3 axes;  ///< columns: unit vectors
  Vec3 half;  ///< half the outer sides [mm]
  double
      corner_radius;   ///< in the plane; edge_radius < corner_radius <= the smaller of half[0], half[1] [mm]
  double edge_radius;  ///< < half[2] [mm]

  Jet distance(const Vec3& p) const;
  Ball ball() const { return {centre, half.norm()}; }
};

/// A rod with round ends whose radius changes smoothly from one end to the other.
struct Capsule {
  Vec3 from, to;
  double radius_from, radius_to;  ///< [mm]

  Jet distance(const Vec3& p) const;
  Ball ball() const {
    return {0.5 * (from + to), 0.5 * (to - from).norm() + std::max(radius_from, radius_to)};
  }
};

/// A right-handed orthonormal frame as columns: the direction of `first`, that of the part of `second`
/// orthogonal to it, and their cross product.
Mat3 frame(const Vec3& first, const Vec3& second);

}  // namespace foramen::synth
