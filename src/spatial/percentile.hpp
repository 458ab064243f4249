#pragma once
/// \file
/// Private to spatial and evaluate: the 95th percentile of errors.

#include <algorithm>
#include <cmath>
#include <vector>

namespace foramen::detail {

/// The smallest of the values that 95 % of them do not exceed. \pre at least one value
inline double percentile_95(std::vector<double> values) {
  const auto rank = static_cast<std::ptrdiff_t>(std::ceil(0.95 * static_cast<double>(values.size())));
  const auto nth = values.begin() + std::max<std::ptrdiff_t>(0, rank - 1);
  std::nth_element(values.begin(), nth, values.end());
  return *nth;
}

}  // namespace foramen::detail
