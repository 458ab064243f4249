#pragma once
/// \file
/// Proof that a torus map is one to one.

#include "foramen/parameterize/torus_map.hpp"

namespace foramen {

struct MapCertificate {
  int triangles = 0;
  int flipped = 0;                 ///< non-positive signed area, by exact integer arithmetic; must be 0
  double smallest_area_ratio = 0;  ///< plane area / surface area, both normalised to 1 in all
  double largest_area_ratio = 0;
  double degree = 0;                ///< sum of signed areas over the domain's area; 1 for a map of degree one
  bool periods_consistent = false;  ///< jumps antisymmetric and closed round every face
  bool valid() const;               ///< no flip, degree 1 within 1e-9, periods consistent
};

/// \pre quantised positions (see quantised()); others are quantised first.
MapCertificate certify(const Mesh& mesh, const TorusMap& map);

}  // namespace foramen
