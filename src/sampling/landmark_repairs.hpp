#pragma once
/// \file
/// Local changes of the landmark triangulation that may repair a guilty triangle (defined at
/// refine_landmarks()), and their evaluation.

#include <compare>
#include <vector>

#include "sampling/lifted_landmarks.hpp"

namespace foramen::detail {

/// The defects of a set of triangles. In comparisons one flip outweighs any number of intersections.
struct Guilt {
  int flipped = 0;  ///< number of flipped or degenerate triangles
  /// Number of triangles that they intersect, so an intersecting pair in the set counts twice.
  int meetings = 0;
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
  Fixed2 place;              ///< new position of the moved vertex
  std::vector<int> support;  ///< vertices that must not have changed since the repair was evaluated
  Guilt guilt_after;         ///< guilt of the changed triangles over all shapes
  double roundness =
      0;  ///< minimum over the changed triangles of the mean over shapes of the smallest angle, radians
};

/// Whether a new landmark is allowed: with `helpful` if it does not raise the guilt, with `any` also
/// otherwise.
enum class Insertion { none, helpful, any };

/// The best change at a guilty face; changes without a new landmark are preferred. Modifies nothing.
Repair best_repair(const TorusTriangulation& mesh, const LiftedLandmarks& lifted, const GuiltTable& guilt,
                   int face, Insertion insertion);

}  // namespace foramen::detail
