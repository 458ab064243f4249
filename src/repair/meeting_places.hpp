#pragma once
// Groups ("places") of intersecting triangles that can be repaired independently of each other.

#include <utility>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// Number of rings of vertices around intersecting triangles that belong to a place.
inline constexpr int place_rings = 2;

struct MeetingPlaces {
  MeetingPlaces(const Mesh& mesh, const std::vector<std::pair<FaceId, FaceId>>& pairs);

  int count = 0;
  /// 0: vertex of an intersecting triangle; 1 to place_rings: rings around them; -1: in no place.
  VertexMap<int> ring;
  VertexMap<int> of_vertex;  ///< index of the place; -1: none
  FaceMap<int> of_face;      ///< place of a face that has a vertex in it; -1: none
};

}  // namespace foramen::repair_detail
