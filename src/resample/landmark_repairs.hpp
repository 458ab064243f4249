#pragma once
/// \file
/// The local changes that may repair a guilty landmark triangle, and how good each would be.

#include <vector>

#include "resample/lifted_landmarks.hpp"

namespace foramen::detail {

/// How guilty every triangle is on every shape: flipped_guilt if it is flipped or degenerate, and 1 for each
/// triangle it meets.
using GuiltTable = std::vector<std::vector<int>>;  // [shape][face]
/// More than the triangles any triangle meets.
inline constexpr int flipped_guilt = 1000;

enum class RepairKind { none, flip, move, split_edge, split_face };

struct Repair {
  RepairKind kind = RepairKind::none;
  int element = -1;          ///< halfedge (flip, split_edge), vertex (move) or face (split_face)
  Fixed2 place;              ///< of the moved vertex
  std::vector<int> support;  ///< vertices that must not have changed since
  int guilt_after = 0;       ///< over the changed triangles and all shapes
  double roundness =
      0;  ///< smallest over the changed triangles of the mean over shapes of its smallest angle
};

/// `helpful`: a new landmark must leave no more guilt than there was; `any`: the least there can be.
enum class Insertion { none, helpful, any };

/// The best change at a guilty face; one without a new landmark is preferred. Reads only.
Repair best_repair(const TorusTriangulation& mesh, const LiftedLandmarks& lifted, const GuiltTable& guilt,
                   int face, Insertion insertion);

}  // namespace foramen::detail
