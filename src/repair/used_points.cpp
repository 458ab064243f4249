#include "repair/used_points.hpp"

namespace foramen::repair_detail {

std::vector<int> keep_used_points(TriangleSoup& surface) {
  std::vector<int> index(surface.points.size(), -1);
  for (const auto& triangle : surface.triangles)
    for (const int corner : triangle) index[corner] = 0;
  std::vector<int> former;
  for (int v = 0; v < std::ssize(index); ++v) {
    if (index[v] < 0) continue;
    index[v] = static_cast<int>(former.size());
    surface.points[former.size()] = surface.points[v];
    former.push_back(v);
  }
  surface.points.resize(former.size());
  for (auto& triangle : surface.triangles)
    for (int& corner : triangle) corner = index[corner];
  return former;
}

}  // namespace foramen::repair_detail
