#pragma once
// Removal of triangles of zero area.

#include <vector>

#include "repair/patching.hpp"

namespace foramen::repair_detail {

struct WithoutZeroArea {
  EditedMesh edited;
  std::vector<Vec3> positions;  ///< one per removed triangle of zero area, mm
};

/// Removes triangles of zero area one by one: a short side is collapsed to one of its ends; otherwise the
/// longest side is flipped; otherwise the triangles around it are replaced by a disk. Throws InvalidInput
/// with a position if a triangle cannot be removed. \pre closed
WithoutZeroArea without_zero_area(const Mesh& mesh);

}  // namespace foramen::repair_detail
