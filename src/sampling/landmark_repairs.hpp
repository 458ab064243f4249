#pragma once
/// \file
/// The local changes that may repair a guilty landmark triangle, and how good each would be.

#include <compare>
#include <vector>

#include "sampling/lifted_landmarks.hpp"

namespace foramen::detail {

/// What is wrong with triangles. A flip outweighs any number of meetings.
struct Guilt {
  int flipped = 0;   ///< triangles that are flipped or degenerate
  int meetings = 0;  ///< triangles met, so that a pair of guilty triangles counts twice
  friend auto operator<=>(const Guilt&, const Guilt&) = default;
};

inline Guilt operator+(const Guilt& a, const Guilt& b) {
  return {a.flipped + b.flipped, a.meetings + b.meetings};
}
inline Guilt operator-(const Guilt& a, const Guilt& b) {
  return {a.flipped - b.flipped, a.meetings - b.meetings};
}

using GuiltTable = std::vector<std::vector<Guilt>>;  // [shape][face]

enum class RepairKind { none, flip, move, split_edge, split_face };

struct Repair {
  RepairKind kind = RepairKind::none;
  int element = -1;          ///< halfedge (flip, split_edge), vertex (move) or face (split_face)
  Fixed2 place;              ///< of the moved vertex
  std::vector<int> support;  ///< vertices that must not have changed since
  Guilt guilt_after;         ///< over the changed triangles and all shapes
  double roundness =
      0;  ///< smallest over the changed triangles of the mean over shapes of its smallest angle
};

/// `helpful`: a new landmark must leave no more guilt than there was; `any`: the least there can be.
enum class Insertion { none, helpful, any };

/// The best change at a guilty face; one without a new landmark is preferred. Reads only.
Repair best_repair(const TorusTriangulation& mesh, const LiftedLandmarks& lifted, const GuiltTable& guilt,
                   int face, Insertion insertion);

}  // namespace foramen::detail
