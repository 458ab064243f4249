#pragma once
/// \file
/// Rigid alignment by iterated closest points (ICP) that compares positions and normals, from any initial
/// orientation.

#include "foramen/core/geometry.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

struct AlignOptions {
  double normal_weight = 8.0;
  int sample_points = 4000;
  int coarse_iterations = 6;  ///< the best few starts get twice as many further ones
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

/// A rigid alignment and its quality.
struct Alignment {
  /// Maps coordinates of `moving` to those of `fixed`.
  RigidTransform transform = RigidTransform::Identity();
  /// Mean over the samples of both shapes of min(d, 12 mm), where d^2 = |p - q|^2 + normal_weight^2 |n - m|^2
  /// is measured to the nearest vertex of the other shape, mm. A mesh of fewer than 10 000 vertices is
  /// represented by 10 000 samples instead of its vertices.
  double residual = 0;
  /// The same for the next best start that ended in another pose, without the fine iterations, mm. If it is
  /// close to `residual`, the alignment is ambiguous. Infinity if all starts ended in one pose.
  double second_best = 0;
  int iterations = 0;  ///< fine iterations
  bool converged = false;
};

/// ICP \cite besl1992 with the centroids and all 24 proper matchings of principal axes as starts. Samples of
/// each shape are matched with the nearest points of the other by position and normal, and Tukey's biweight
/// removes matches of parts that the other shape does not have. Each step minimises a mixture of the distance
/// along the mean of both normals (symmetric point-to-plane distance, \cite rusinkiewicz2019) and of the
/// distance itself.
///
/// The transform is a rotation and a translation, without reflection or scaling. The result is deterministic
/// and, up to rounding, does not depend on the pose of `moving`; exchanging the two shapes gives the inverse
/// transform. Throws InvalidInput for a surface of zero area and for options out of range.
Alignment align(const Mesh& moving, const Mesh& fixed, const RunContext& ctx,
                const AlignOptions& options = {});

}  // namespace foramen
