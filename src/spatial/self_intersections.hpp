#pragma once
/// \file
/// Where a surface passes through, touches or lies on itself.

#include <utility>
#include <vector>

#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

struct SelfIntersectionsOptions {
  /// Stops with ConvergenceError when more pairs of triangles than this, times the number of triangles, have
  /// boxes that meet; 0: no limit. A surface that is embedded has about ten.
  int most_overlaps_per_triangle = 0;
};

/// All pairs of triangles that have a point in common beyond what they share as neighbours, the smaller index
/// first, in order. Triangles are closed sets, so touching counts. A pair counts when the two
/// - share no vertex and have any point in common;
/// - share one vertex and have any other point in common;
/// - share an edge and lie in one plane, on the same side of that edge: folded onto each other;
/// - share all three vertices.
///
/// A mesh without such a pair is embedded. A triangle without area (corners exactly on one line) is passed
/// over: all its points lie on edges, which its neighbours have too. Sharing is by index: two vertices at the
/// same place are not one. Every decision is exact for the coordinates as they are (signs of determinants,
/// \cite shewchuk1997); \pre each is 0 or between 1e-80 and 1e80 in absolute value.
std::vector<std::pair<FaceId, FaceId>> self_intersections(const TriangleTree& surface,
                                                          const SelfIntersectionsOptions& options = {});

}  // namespace foramen
