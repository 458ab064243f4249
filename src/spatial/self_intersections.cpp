#include "spatial/self_intersections.hpp"

#include <algorithm>
#include <cstdint>

#include "foramen/core/error.hpp"
#include "spatial/triangles_meet.hpp"

namespace foramen {

std::vector<std::pair<FaceId, FaceId>> self_intersections(const TriangleTree& surface,
                                                          const SelfIntersectionsOptions& options) {
  const Mesh& mesh = surface.mesh();
  FaceMap<char> solid(mesh.face_count());
  for (FaceId f : mesh.faces()) solid[f] = has_area(mesh.triangle(f));
  std::vector<std::pair<FaceId, FaceId>> pairs;
  const std::int64_t limit = std::int64_t(options.most_overlaps_per_triangle) * mesh.face_count();
  std::int64_t overlaps = 0;
  surface.for_each_overlap([&](FaceId f, FaceId g) {
    if (++overlaps > limit && limit > 0)
      throw ConvergenceError("the surface runs through itself in too many places to list them");
    if (solid[f] && solid[g] && triangles_meet(numbered_triangle(mesh, f), numbered_triangle(mesh, g)))
      pairs.emplace_back(f, g);
  });
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

}  // namespace foramen
