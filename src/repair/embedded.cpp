#include "repair/embedded.hpp"

#include <algorithm>

#include "spatial/self_intersections.hpp"

namespace foramen::repair_detail {
namespace {

// Largest number of pairs of intersecting bounding boxes per triangle; an embedded surface has about ten.
constexpr int most_overlaps_per_triangle = 100;

}  // namespace

std::vector<std::pair<FaceId, FaceId>> meeting_pairs(const Mesh& mesh) {
  return self_intersections(TriangleTree(mesh), {.most_overlaps_per_triangle = most_overlaps_per_triangle});
}

bool new_faces_are_embedded(const Mesh& mesh, int first) {
  const auto pairs = meeting_pairs(mesh);
  return std::none_of(pairs.begin(), pairs.end(),
                      [&](const auto& pair) { return pair.second.index >= first; });
}

}  // namespace foramen::repair_detail
