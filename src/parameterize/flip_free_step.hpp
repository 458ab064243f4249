#pragma once
/// \file
/// The largest step along a line before a triangle collapses (Smith and Schaefer 2015).

#include <limits>

#include "parameterize/map_energy.hpp"

namespace foramen {

/// The smallest s > 0 for which the triangle with edges q + s d has zero area; +inf if there is none. \pre
/// doubled_area(q) > 0
double first_collapse(const Vec4& q, const Vec4& d);

/// The minimum over all triangles if the state moves along `direction`, in positions and lattice.
double first_collapse(const MapEnergy& energy, const MapState& state, const MapState& direction);

}  // namespace foramen
