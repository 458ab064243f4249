#include "repair/edge_sides.hpp"

#include <algorithm>
#include <tuple>

namespace foramen::repair_detail {

EdgeSides::EdgeSides(const std::vector<std::array<int, 3>>& triangles) {
  sides_.reserve(3 * triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = triangles[f][k], b = triangles[f][(k + 1) % 3];
      sides_.push_back({std::min(a, b), std::max(a, b), static_cast<int>(3 * f + k), a < b});
    }
  std::sort(sides_.begin(), sides_.end(), [](const Side& x, const Side& y) {
    return std::tie(x.low, x.high, x.halfedge) < std::tie(y.low, y.high, y.halfedge);
  });
  for (std::size_t i = 0; i < sides_.size(); ++i)
    if (i == 0 || sides_[i].low != sides_[i - 1].low || sides_[i].high != sides_[i - 1].high)
      first_.push_back(i);
  first_.push_back(sides_.size());
}

}  // namespace foramen::repair_detail
