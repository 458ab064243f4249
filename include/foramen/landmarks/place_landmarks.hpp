#pragma once
/// \file
/// The second stage: landmarks are chosen on the mean of all shapes and placed on every shape.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/correspond/correspond.hpp"
#include "foramen/model/procrustes.hpp"
#include "foramen/sampling/landmark_mesh.hpp"

namespace foramen {

/// How landmarks are distributed over the mean.
struct LandmarkSpreadOptions {
  int grid_points = 65000;
  CurvatureDensityOptions density = {};
  int relaxation_rounds = RemeshOptions{}.relaxation_rounds;
  int density_updates = 3;
  ErrorDensityOptions errors = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<LandmarkSpreadOptions> auto& o) {
  visit(o.grid_points, {.name = "grid_points",
                        .range = at_least(16),
                        .meaning = "points of the dense uniform sampling of the torus"});
  visit(o.density, {.nesting = Nesting::inlined});
  visit(o.relaxation_rounds,
        {.name = "relaxation_rounds", .range = at_least(0), .meaning = "rounds of Lloyd relaxation"});
  visit(o.density_updates, {.name = "density_updates",
                            .range = at_least(0),
                            .meaning = "times that the density is raised where the landmarks miss a shape"});
  visit(o.errors, {.nesting = Nesting::inlined});
}

struct PlaceLandmarksOptions {
  int count = 4000;
  std::optional<double> target_error_mm =
      std::nullopt;  ///< If set, it determines the number of landmarks instead of `count`.
  ScaleMode scale = ScaleMode::keep;
  std::uint64_t seed = 1;
  LandmarkSpreadOptions spread = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<PlaceLandmarksOptions> auto& o) {
  visit(o.count, {.name = "landmarks",
                  .range = at_least(50).up_to(200000),
                  .meaning = "number of landmarks (refinement may add 5 %)"});
  visit(o.target_error_mm, {.name = "target_error",
                            .unit = "mm",
                            .range = above(0),
                            .meaning = "as few landmarks as represent the shapes this well"});
  visit(o.scale, {.name = "scale",
                  .meaning = "keep or remove the shapes' size in the mean on which landmarks are placed"});
  visit(o.seed,
        {.name = "seed", .meaning = "seed of the samples by which the error of representation is measured"});
  visit(o.spread, {.name = "resampling"});
}

/// Landmarks on all shapes.
struct Landmarks {
  std::vector<std::string> names;  ///< names of the shapes, in the order of the correspondence
  /// Per shape: the landmarks on its surface, in its own coordinates, mm.
  std::vector<std::vector<Vec3>> points;
  LandmarkMesh mesh;  ///< their positions on the torus, and the triangles, which are the same for all shapes
  int inserted = 0;   ///< number of landmarks inserted by refinement
  int remaining_flips = 0;  ///< see RefinedLandmarks::remaining; must be 0
  int initial_self_intersections = 0, remaining_self_intersections = 0;  ///< see RefinedLandmarks
  /// With Method::icp: per shape the number of landmarks without a point of compatible normal on it.
  /// Otherwise empty.
  std::vector<int> without_compatible;
};

/// Places landmarks on all shapes. They are distributed by curvature over the dense mean of all shapes. Their
/// density is raised where they represent a shape badly (raised_by_error()), and they are repaired where a
/// triangle is flipped or intersects another on some shape (refine_landmarks()). With Method::icp the
/// landmarks of the remeshed reference are moved to the closest compatible points of the other shapes
/// (icp_correspondence()).
///
/// \param shapes  the shapes that were given to correspond(); they are found by their names
/// \param correspondence  consumed, so that the memory of the maps of many large shapes is released early
/// Throws ConvergenceError if the target error is not reached with 30 000 landmarks.
Landmarks place_landmarks(std::span<const Shape> shapes, Correspondence correspondence,
                          const PlaceLandmarksOptions& options, const RunContext& ctx);

/// The landmarks of a finished placement on a shape that is not in the cohort, in the coordinates of the
/// shape, mm. The shape is registered by register_to_group(), register_shape() or icp_correspondence(),
/// depending on the options, and the landmarks are lifted to it. Throws the errors of these functions.
std::vector<Vec3> landmarks_on_newcomer(const Mesh& shape, const CohortRegistration& cohort,
                                        const Landmarks& landmarks, const CorrespondOptions& options,
                                        const RunContext& ctx);

}  // namespace foramen
