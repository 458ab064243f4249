#pragma once
/// \file
/// Rigid alignment by iterated closest points with normals in the similarity, from any scanner orientation.

#include "foramen/core/geometry.hpp"
#include "foramen/core/run_context.hpp"

namespace foramen {

struct AlignOptions {
  double normal_weight = 8.0;     ///< mm per unit of normal difference in the 6-D neighbour search. >= 0.
  int sample_points = 4000;       ///< vertices of the moving shape used per iteration (all if fewer)
  int coarse_iterations = 6;      ///< for each of the 24 starts
  int iteration_limit = 100;
  double tolerance = 1e-4;        ///< Stops when the motion of an iteration moves no sample point by more than this [mm].
};

struct Alignment {
  RigidTransform transform = RigidTransform::Identity();  ///< moving -> fixed
  double residual = 0;       ///< robust mean distance at the end, mm
  double second_best = 0;    ///< residual of the next best start that ended elsewhere, mm: close to `residual` = ambiguous
  int iterations = 0;
  bool converged = false;
};

/// ICP (Besl and McKay 1992) from the centroid and all 24 proper matchings of principal axes; robust (Tukey) weights.
/// Deterministic; the result does not depend on the pose of `moving` beyond rounding. No reflection, no scale.
Alignment align(const Mesh& moving, const Mesh& fixed, const RunContext& ctx, const AlignOptions& options = {});

}  // namespace foramen
