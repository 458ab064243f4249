#pragma once
// Where triangles meet that should not, in groups that can be mended apart from each other.

#include <utility>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// Rings of vertices round the triangles that meet.
inline constexpr int place_rings = 2;

struct MeetingPlaces {
  MeetingPlaces(const Mesh& mesh, const std::vector<std::pair<FaceId, FaceId>>& pairs);

  int count = 0;
  VertexMap<int> ring;       ///< 0: of a triangle that meets another, up to place_rings; -1: in no place
  VertexMap<int> of_vertex;  ///< place; -1: none
  FaceMap<int> of_face;      ///< place of a face with a vertex in it; -1: none
};

}  // namespace foramen::repair_detail
