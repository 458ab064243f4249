#pragma once
/// \file
/// Rigid alignment by iterated closest points with normals in the similarity, from any scanner orientation.

#include "foramen/core/geometry.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

struct AlignOptions {
  double normal_weight = 8.0;
  int sample_points = 4000;
  int coarse_iterations = 6;  ///< twice as many more for the best few starts
  int iteration_limit = 100;
  double tolerance = 1e-4;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<AlignOptions> auto& o) {
  visit(o.normal_weight, {.name = "normal_weight",
                          .unit = "mm",
                          .range = at_least(0),
                          .meaning = "distance that a unit of normal difference counts as in the searches"});
  visit(o.sample_points, {.name = "sample_points",
                          .range = at_least(2),
                          .meaning = "surface samples matched per iteration, half of them on each shape"});
  visit(o.coarse_iterations, {.name = "coarse_iterations",
                              .range = at_least(0),
                              .meaning = "iterations from each of the 24 starts"});
  visit(o.iteration_limit,
        {.name = "iteration_limit", .range = at_least(0), .meaning = "most fine iterations"});
  visit(o.tolerance,
        {.name = "tolerance",
         .unit = "mm",
         .range = at_least(0),
         .meaning = "largest motion of a sample point in an iteration at which the search stops"});
}

struct Alignment {
  RigidTransform transform = RigidTransform::Identity();  ///< moving -> fixed
  /// Mean over the samples of both shapes of min(d, 12 mm), d^2 = |p - q|^2 + normal_weight^2 |n - m|^2 to
  /// the other shape's nearest vertex (of a coarse mesh: nearest of 10 000 samples), mm.
  double residual = 0;
  /// The same of the next best start that ended elsewhere, without the fine iterations: close to `residual` =
  /// ambiguous. Infinity if all starts agree.
  double second_best = 0;
  int iterations = 0;  ///< fine ones
  bool converged = false;
};

/// ICP (Besl and McKay 1992, \cite besl1992) from the centroid and all 24 proper matchings of principal axes.
/// Samples of each shape are matched with the other's nearest points by position and normal; Tukey's weights
/// leave out what the other shape does not have; the step minimises a mix of the distance along the mean of
/// both normals (the symmetric form of point-to-plane, Rusinkiewicz 2019, \cite rusinkiewicz2019) and of the
/// distance itself. Deterministic; the result does not depend on the pose of `moving` beyond rounding. Both
/// shapes play the same part: exchanged, they give the inverse motion. No reflection, no scale. Throws
/// InvalidInput for a surface without area or an option out of its range.
Alignment align(const Mesh& moving, const Mesh& fixed, const RunContext& ctx,
                const AlignOptions& options = {});

}  // namespace foramen
