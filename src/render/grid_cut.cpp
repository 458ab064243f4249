#include "render/grid_cut.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace foramen {
namespace {

using Polygon = std::vector<GridCorner>;

// The point of the side a-b at which the coordinate `axis` has the value `at`. This value lies strictly
// between those of a and b. std::lerp does not leave the range of its ends, so the other coordinate stays
// inside its cell.
GridCorner crossing(const GridCorner& a, const GridCorner& b, int axis, double at) {
  const double s = (at - a.at[axis]) / (b.at[axis] - a.at[axis]);
  GridCorner c;
  c.at[axis] = at;
  c.at[1 - axis] = std::lerp(a.at[1 - axis], b.at[1 - axis], s);
  for (int k = 0; k < 3; ++k) c.barycentric[k] = std::lerp(a.barycentric[k], b.barycentric[k], s);
  return c;
}

// The parts of a convex polygon on both sides of a line; corners on the line belong to both.
std::pair<Polygon, Polygon> split(const Polygon& polygon, int axis, double at) {
  Polygon low, high;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const GridCorner& a = polygon[i];
    const GridCorner& b = polygon[(i + 1) % polygon.size()];
    if (a.at[axis] <= at) low.push_back(a);
    if (a.at[axis] >= at) high.push_back(a);
    if (std::min(a.at[axis], b.at[axis]) < at && at < std::max(a.at[axis], b.at[axis])) {
      const GridCorner c = crossing(a, b, axis, at);
      low.push_back(c);
      high.push_back(c);
    }
  }
  return {std::move(low), std::move(high)};
}

// The polygon cut along the grid lines of one direction: its strips, each with its number.
std::vector<std::pair<int, Polygon>> strips(Polygon polygon, int axis) {
  const auto [least, greatest] =
      std::minmax_element(polygon.begin(), polygon.end(),
                          [&](const GridCorner& a, const GridCorner& b) { return a.at[axis] < b.at[axis]; });
  const int first = static_cast<int>(std::floor(least->at[axis]));
  const double end = greatest->at[axis];
  std::vector<std::pair<int, Polygon>> out;
  int strip = first;
  for (; strip + 1 < end; ++strip) {
    auto [low, high] = split(polygon, axis, strip + 1);
    out.emplace_back(strip, std::move(low));
    polygon = std::move(high);
  }
  out.emplace_back(strip, std::move(polygon));
  return out;
}

}  // namespace

std::vector<GridPiece> cut_by_grid(const std::array<Vec2, 3>& triangle) {
  const Polygon whole{
      {triangle[0], Vec3::UnitX()}, {triangle[1], Vec3::UnitY()}, {triangle[2], Vec3::UnitZ()}};
  std::vector<GridPiece> pieces;
  for (auto& [column, part] : strips(whole, 0))
    for (auto& [row, polygon] : strips(std::move(part), 1))
      pieces.push_back({Vec2i(column, row), std::move(polygon)});
  return pieces;
}

}  // namespace foramen
