#pragma once
/// \file
/// How far one may go along a line before a triangle loses its area (Smith and Schaefer 2015).

#include <limits>

#include "parameterize/map_energy.hpp"

namespace foramen {

/// The smallest s > 0 at which the triangle with edges q + s d has no area; +inf if there is none. \pre
/// doubled_area(q) > 0.
double first_collapse(const Vec4& q, const Vec4& d);

/// The smallest over all triangles when the state moves along (x, lattice).
double first_collapse(const MapEnergy& energy, const MapState& state, const MapState& direction);

}  // namespace foramen
