#pragma once
/// \file
/// How faithfully corresponding meshes represent the surfaces they stand for.

#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"
#include "foramen/spatial/surface_distance.hpp"

namespace foramen {

/// Where on a shape its corresponding mesh departs from the input surface.
struct ErrorMap {
  std::vector<double> landmark_mm;  ///< per landmark: the largest distance found in its surroundings, mm
  std::vector<int> plain_flips;     ///< triangles, as SampledFlips, in order
  std::vector<int> confirmed_flips;
};

struct ShapeRepresentation {
  SurfaceDistance distance;    ///< corresponding mesh to original input, in the input's own size, mm
  int plain_flips = 0;         ///< triangles opposing the input at their centroid's closest point
  int confirmed_flips = 0;     ///< of these, those opposing every input triangle that may be meant
  int degenerate = 0;          ///< triangles without area
  int opposing_mean = 0;       ///< triangles opposing the same triangle of the mean shape
  int self_intersections = 0;  ///< pairs of triangles of the corresponding mesh, as self_intersections()
  int input_self_intersections = 0;  ///< the same of the original input
  ErrorMap map = {};                 ///< where these distances and flips are
};

struct Representation {
  std::vector<ShapeRepresentation> shapes;
  Estimate mean_surface, p95, hausdorff;                  ///< over shapes, mm
  Estimate plain_flips, confirmed_flips, opposing_mean;   ///< over shapes, triangles
  Estimate self_intersections, input_self_intersections;  ///< over shapes, pairs of triangles
};

/// \param aligned  of the same cohort: its mean shape is what opposing_mean refers to
Representation representation(const CorrespondingCohort& cohort, const AlignedCohort& aligned,
                              const SurfaceDistanceOptions& options, const RunContext& ctx);

}  // namespace foramen
