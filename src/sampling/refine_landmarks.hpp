#pragma once
/// \file
/// Repairs the landmark triangulation where a shape is thinner than its sampling.

#include <span>

#include "foramen/core/run_context.hpp"
#include "foramen/sampling/landmark_mesh.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/remesh.hpp"

namespace foramen {

/// A shape landmarks are lifted to: both of its input surface, in the same coordinates.
struct LandmarkShape {
  const TorusLocator* locator = nullptr;
  const TriangleTree* tree = nullptr;
};

struct RefineLandmarksOptions {
  double budget = 0.05;  ///< At most budget * landmarks are inserted. >= 0.
  int round_limit = 60;  ///< Rounds of changes; a round changes every guilty triangle at most once.
};

struct RefinedLandmarks {
  LandmarkMesh landmarks;  ///< the given ones keep their numbers (some moved); inserted ones follow
  int inserted = 0;        ///< landmarks
  int flips = 0;           ///< of landmark edges
  int moved = 0;           ///< moves of landmarks on the torus
  int initial = 0;         ///< confirmed-flipped or degenerate lifted triangles at the start, over all shapes
  int remaining = 0;       ///< at the end, by sampled_flips() on every shape: 0 is success
  /// Pairs of triangles that meet, over all shapes whose input does not meet itself: once the flips are
  /// mended, and at the end, by self_intersections() on every shape.
  int initial_self_intersections = 0, remaining_self_intersections = 0;
};

/// A landmark triangle is guilty if it is confirmed-flipped or degenerate (sampled_flips()) on any shape
/// after its corners are lifted to that shape's input; once these are mended, also if it meets another
/// triangle on any shape whose input does not meet itself. Each is repaired by the change that leaves the
/// fewest guilty triangles, and the fewest that meet others, on all shapes together: a flip of one of its
/// edges, a move of one of its corners, or, if these do not help and the budget lasts, a landmark in the
/// middle of an edge or of the triangle. All keep the landmarks an embedded triangulation of the torus. No
/// pair of triangles is parted at the price of a flip. Changes are found in parallel and made in order of the
/// triangles, so the result is the same for any number of threads.
RefinedLandmarks refine_landmarks(const LandmarkMesh& landmarks, std::span<const LandmarkShape> shapes,
                                  const RunContext& ctx, const RefineLandmarksOptions& options = {});

}  // namespace foramen
