#pragma once
/// \file
/// A certificate that a torus map is one to one.

#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

/// The result of certify().
struct MapCertificate {
  int triangles = 0;
  int flipped = 0;  ///< triangles of non-positive signed area, by exact integer arithmetic; must be 0
  /// Plane area / surface area of a triangle, where the total areas are normalised to 1.
  double smallest_area_ratio = 0;
  double largest_area_ratio = 0;
  double degree = 0;                ///< sum of signed areas / area of the domain; 1 for a map of degree one
  bool periods_consistent = false;  ///< jumps are antisymmetric and sum to zero around every face
  bool valid() const;               ///< no flipped triangle, degree 1 within 1e-9, periods consistent
};

/// Computes the certificate of a map. Positions that are not quantised (see quantised()) are quantised first.
MapCertificate certify(const Mesh& mesh, const TorusMap& map);

}  // namespace foramen
