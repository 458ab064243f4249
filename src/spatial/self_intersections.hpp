#pragma once
/// \file
/// Self-intersections of a surface: pairs of triangles that cross, touch or overlap.

#include <utility>
#include <vector>

#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {

struct SelfIntersectionsOptions {
  /// Throws ConvergenceError if the number of pairs of triangles with intersecting boxes exceeds this number
  /// times the number of triangles; 0: no limit. An embedded surface has about ten such pairs per triangle.
  int most_overlaps_per_triangle = 0;
};

/// All pairs of triangles that have a point in common other than their common vertices and edges, sorted,
/// with the smaller index first. Triangles are closed sets, so touching counts. A pair counts if the two
/// triangles
/// - share no vertex and have any point in common;
/// - share one vertex and have any other point in common;
/// - share an edge and lie in one plane, on the same side of that edge: folded onto each other;
/// - share all three vertices.
///
/// A mesh without such a pair is embedded. A triangle of zero area (corners exactly on one line) is skipped,
/// because all its points lie on edges of its neighbours. Vertices are compared by index: two vertices at the
/// same position are different. All decisions are exact for the given coordinates (signs of determinants,
/// \cite shewchuk1997).
/// \pre each coordinate is 0 or between 1e-80 and 1e80 in absolute value
std::vector<std::pair<FaceId, FaceId>> self_intersections(const TriangleTree& surface,
                                                          const SelfIntersectionsOptions& options = {});

}  // namespace foramen
