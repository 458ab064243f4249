#include "match/robust_weight.hpp"

#include <algorithm>

#include "foramen/core/error.hpp"

namespace foramen {

double tukey_weight(double squared_ratio) {
  const double rest = std::max(0.0, 1 - squared_ratio);
  return rest * rest;
}

double upper_median(std::vector<double> values) {
  FORAMEN_ASSERT(!values.empty());
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace foramen
