#pragma once
/// \file
/// Repairs the landmark triangulation where its lifted triangles are flipped or intersect, for example on
/// walls that are thinner than the distance of landmarks.

#include <span>

#include "foramen/core/run_context.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/remesh.hpp"

namespace foramen {

/// A shape to which landmarks are lifted. Both members belong to its input surface, in the same coordinates.
struct LandmarkShape {
  const TorusLocator* locator = nullptr;
  const TriangleTree* tree = nullptr;
};

struct RefineLandmarksOptions {
  double budget = 0.05;  ///< At most this share of the number of landmarks is inserted. >= 0.
  int round_limit = 60;  ///< Largest number of rounds; one round changes each guilty triangle at most once.
};

struct RefinedLandmarks {
  /// The given landmarks keep their indices, though some are moved; inserted ones follow.
  LandmarkMesh landmarks;
  int inserted = 0;   ///< number of inserted landmarks
  int flips = 0;      ///< number of flipped landmark edges
  int moved = 0;      ///< number of moves of landmarks on the torus
  int initial = 0;    ///< flipped (confirmed) or degenerate lifted triangles at the start, over all shapes
  int remaining = 0;  ///< the same at the end; 0: all were repaired
  /// Pairs of intersecting triangles (self_intersections()) over all shapes whose input has no
  /// self-intersections: after the repair of flips, and at the end.
  int initial_self_intersections = 0, remaining_self_intersections = 0;
};

/// A landmark triangle is called guilty if, lifted to the input surface of some shape, it is degenerate or
/// its flip is confirmed (see SampledFlips). After these triangles are repaired, a triangle is also guilty if
/// it intersects another one on a shape whose input has no self-intersections.
///
/// A guilty triangle is repaired by the local change that leaves the fewest flipped triangles and then the
/// fewest intersections over all shapes: a flip of one of its edges, a move of one of its corners, or, if
/// these do not help and the budget allows it, a new landmark in the middle of an edge or of the triangle.
/// All changes keep the landmarks an embedded triangulation of the torus. No intersection is removed at the
/// cost of a flip. Changes are found in parallel and made in order of the triangles, so the result does not
/// depend on the number of threads. Throws InvalidInput for a negative budget.
RefinedLandmarks refine_landmarks(const LandmarkMesh& landmarks, std::span<const LandmarkShape> shapes,
                                  const RunContext& ctx, const RefineLandmarksOptions& options = {});

}  // namespace foramen
