#pragma once
// Triangles whose corners lie on one line.

#include <vector>

#include "repair/patching.hpp"

namespace foramen::repair_detail {

struct WithoutZeroArea {
  EditedMesh edited;
  std::vector<Vec3> positions;  ///< of each triangle without area, as it was
};

/// Removes them one by one: a short side is collapsed to one of its ends, otherwise the longest side is
/// flipped, otherwise the triangles round it are replaced by a disk. Throws InvalidInput naming the place if
/// one is left. \pre closed
WithoutZeroArea without_zero_area(const Mesh& mesh);

}  // namespace foramen::repair_detail
