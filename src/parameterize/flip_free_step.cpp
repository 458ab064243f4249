#include "parameterize/flip_free_step.hpp"

#include <algorithm>
#include <cmath>

namespace foramen {

double first_collapse(const Vec4& q, const Vec4& d) {
  // doubled_area(q + s d) = a s^2 + b s + c. For c > 0 its smallest positive root is 2c / (sqrt(disc) - b).
  // This form has no cancellation and holds for a = 0 and both signs of a. If the denominator is <= 0, there
  // is no positive root.
  const double a = doubled_area(d), c = doubled_area(q);
  const double b = q[0] * d[3] + d[0] * q[3] - q[1] * d[2] - d[1] * q[2];
  const double discriminant = b * b - 4 * a * c;
  if (!(discriminant >= 0)) return std::numeric_limits<double>::infinity();
  const double denominator = std::sqrt(discriminant) - b;
  return denominator > 0 ? 2 * c / denominator : std::numeric_limits<double>::infinity();
}

double first_collapse(const MapEnergy& energy, const MapState& state, const MapState& direction) {
  double least = std::numeric_limits<double>::infinity();
  for (const MapEnergy::Triangle& t : energy.triangles())
    least = std::min(least, first_collapse(MapEnergy::edges(t, state), MapEnergy::edges(t, direction)));
  return least;
}

}  // namespace foramen
