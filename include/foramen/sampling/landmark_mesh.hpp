#pragma once
/// \file
/// The triangles that all shapes share, and how their corners, the landmarks, are distributed over a surface:
/// options of curvature_density(), raised_by_error() and remesh().

#include <array>
#include <vector>

#include "foramen/core/mesh.hpp"
#include "foramen/core/options.hpp"

namespace foramen {

/// A triangulation of the torus whose vertices are landmarks.
struct LandmarkMesh {
  std::vector<Vec2> turns;  ///< torus position of each landmark
  std::vector<std::array<int, 3>> triangles;
  HalfedgeMap<Vec2i> jumps;  ///< of halfedge 3f+k, as in TorusMap
};

/// The results are not sensitive to these options: on real lumbar vertebrae the representation error hardly
/// changes for contrasts of 0.35 to 0.5, floors of 0.05 to 0.15 and radii of 0.007 to 0.015.
struct CurvatureDensityOptions {
  /// Exponent of the curvature in the density. An edge of length h deviates from a surface of curvature k by
  /// h^2 k / 8, and the measure used here has the dimension of k^2, so 0.5 distributes the largest errors
  /// evenly. 0.25 gives a smaller mean error.
  double contrast = 0.5;
  double floor = 0.15;
  /// In each round a density becomes the average of itself and the mean of its neighbours.
  int smoothing_rounds = 5;
  /// Standard deviation of the kernel that averages the curvature tensor, relative to the square root of the
  /// area; about 1 mm on a vertebra. Features below this size, such as the steps of voxels, have little
  /// effect.
  double curvature_radius = 0.008;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<CurvatureDensityOptions> auto& o) {
  visit(o.contrast, {.name = "density_contrast",
                     .range = at_least(0),
                     .meaning = "power of the curvature that the density of landmarks follows; 0: uniform"});
  visit(o.floor, {.name = "density_floor",
                  .range = above(0).up_to(1),
                  .meaning = "least density of landmarks relative to the largest"});
  visit(o.smoothing_rounds, {.name = "density_smoothing_rounds",
                             .range = at_least(0),
                             .meaning = "rounds in which the density is smoothed"});
  visit(
      o.curvature_radius,
      {.name = "curvature_radius",
       .range = above(0),
       .meaning =
           "standard deviation of the kernel that averages the curvature tensor, relative to the square root "
           "of the surface's area"});
}

struct ErrorDensityOptions {
  double accepted_mm = 0.5;
  double exponent = 1.0;
  int spread_rings = 3;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<ErrorDensityOptions> auto& o) {
  visit(o.accepted_mm,
        {.name = "accepted_error",
         .unit = "mm",
         .range = above(0),
         .meaning = "distance between a shape and its landmarks up to which no landmarks are added"});
  visit(
      o.exponent,
      {.name = "error_exponent",
       .range = at_least(0),
       .meaning = "an error of r times the accepted one raises the density of landmarks by r to this power"});
  visit(o.spread_rings, {.name = "error_spread_rings",
                         .range = at_least(0),
                         .meaning = "rings of grid points that an error reaches"});
}

struct RemeshOptions {
  int landmarks = 4000;
  int relaxation_rounds = 80;  ///< rounds of Lloyd relaxation
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<RemeshOptions> auto& o) {
  visit(o.landmarks, {.name = "landmarks", .range = at_least(16), .meaning = "number of landmarks"});
  visit(o.relaxation_rounds,
        {.name = "relaxation_rounds", .range = at_least(0), .meaning = "rounds of Lloyd relaxation"});
}

}  // namespace foramen
