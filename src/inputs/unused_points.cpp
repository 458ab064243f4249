#include "inputs/unused_points.hpp"

#include <string>
#include <vector>

namespace foramen {

std::optional<Message> drop_unused_points(TriangleSoup& surface) {
  const int points = static_cast<int>(surface.points.size());
  std::vector<int> index(surface.points.size(), -1);
  for (const auto& triangle : surface.triangles)
    for (const int corner : triangle) {
      if (corner < 0 || corner >= points) return std::nullopt;
      index[corner] = 0;
    }
  int kept = 0;
  for (int v = 0; v < points; ++v) {
    if (index[v] < 0) continue;
    index[v] = kept;
    surface.points[kept++] = surface.points[v];
  }
  const int dropped = points - kept;
  if (dropped == 0 || kept == 0) return std::nullopt;
  surface.points.resize(kept);
  for (auto& triangle : surface.triangles)
    for (int& corner : triangle) corner = index[corner];
  return Message(std::to_string(dropped) + (dropped == 1
                                                ? " point belongs to no triangle and was left out"
                                                : " points belong to no triangle and were left out"));
}

}  // namespace foramen
