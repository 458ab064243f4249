#pragma once
/// \file
/// ICP from a given pose: matches and rigid steps in turn.

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "foramen/core/run_context.hpp"
#include "match/oriented_points.hpp"
#include "match/rigid_step.hpp"

namespace foramen::detail {

/// A pose of the moving surface on the fixed one, and how it was reached.
struct Pose {
  RigidTransform at = RigidTransform::Identity();
  double residual = std::numeric_limits<double>::infinity();  ///< mean_residual() of the matches there
  int iterations = 0;                                         ///< all that led to it
  bool converged = false;                                     ///< Whether the last descent did.
};

/// The matches of the moving surface with the fixed one at a pose.
using Matching = std::function<std::vector<Match>(const RigidTransform& at)>;

/// Every sample, at the pose, with the nearest target.
std::vector<Match> matches_of(std::span<const OrientedPoint> samples, const IndexedPoints& targets,
                              const RigidTransform& at);

/// Mean of the matches' distances, each counted as 12 mm at most, mm. \pre matches are not empty
double mean_residual(std::span<const Match> matches);

struct DescentOptions {
  int iteration_limit = 0;  ///< >= 0
  double tolerance = 0;     ///< Stops when a step moves no matched point by more than this [mm]. >= 0.
  /// Step k, from 0, is taken by 1 / max(1, k - full_steps + 1): matches can go round in a cycle, and shorter
  /// steps average it. >= 0.
  int full_steps = std::numeric_limits<int>::max();
};

Pose descend(const Pose& start, const Matching& matching, const DescentOptions& options,
             const RunContext& ctx);

void sort_best_first(std::vector<Pose>& poses);

/// Whether two poses differ in rotation by less than 0.2 rad.
bool same_answer(const Pose& a, const Pose& b);

/// Of those that are the same answer the first, and at most `most` of all.
std::vector<Pose> distinct_answers(std::span<const Pose> poses, int most = std::numeric_limits<int>::max());

}  // namespace foramen::detail
