#pragma once
/// \file
/// Representation error: how well corresponding meshes represent the original surfaces.

#include <vector>

#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"
#include "foramen/spatial/surface_distance.hpp"

namespace foramen {

/// The local deviation of a corresponding mesh from its input surface.
struct ErrorMap {
  std::vector<double> landmark_mm;  ///< per landmark: the largest distance in its neighbourhood, mm
  std::vector<int> plain_flips;     ///< indices of triangles, in order; see SampledFlips
  std::vector<int> confirmed_flips;
};

/// The representation error of one shape.
struct ShapeRepresentation {
  /// Distances between the corresponding mesh and the original input, in the size of the input, mm.
  SurfaceDistance distance;
  int plain_flips = 0;         ///< triangles that oppose the input at the point closest to their centroid
  int confirmed_flips = 0;     ///< those of them that are confirmed, see SampledFlips
  int degenerate = 0;          ///< triangles of zero area
  int opposing_mean = 0;       ///< triangles that oppose the same triangle of the mean shape
  int self_intersections = 0;  ///< pairs of triangles of the corresponding mesh, see self_intersections()
  int input_self_intersections = 0;  ///< the same for the original input
  ErrorMap map = {};                 ///< positions of these distances and flips
};

/// The representation error of a cohort.
struct Representation {
  std::vector<ShapeRepresentation> shapes;
  Estimate mean_surface, p95, hausdorff;                  ///< over shapes, mm
  Estimate plain_flips, confirmed_flips, opposing_mean;   ///< over shapes, triangles
  Estimate self_intersections, input_self_intersections;  ///< over shapes, pairs of triangles
};

/// \param aligned  the same cohort aligned; opposing_mean refers to its mean shape
Representation representation(const CorrespondingCohort& cohort, const AlignedCohort& aligned,
                              const SurfaceDistanceOptions& options, const RunContext& ctx);

}  // namespace foramen
