#pragma once
/// \file
/// Rigid alignment by iterated closest points with normals in the similarity, from any scanner orientation.

#include "foramen/core/geometry.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

struct AlignOptions {
  double normal_weight = 8.0;  ///< mm per unit of normal difference in the 6-D neighbour search. >= 0.
  int sample_points = 4000;    ///< Surface samples matched per iteration, half of them on each shape. >= 2.
  int coarse_iterations = 6;   ///< for each of the 24 starts; twice as many more for the best few. >= 0.
  int iteration_limit = 100;   ///< of the fine iterations. >= 0.
  double tolerance =
      1e-4;  ///< Stops when the motion of an iteration moves no sample point by more than this [mm].
};

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
