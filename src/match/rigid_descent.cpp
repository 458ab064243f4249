#include "match/rigid_descent.hpp"

#include <algorithm>
#include <cmath>

#include "spatial/point_index.hpp"

namespace foramen::detail {
namespace {

constexpr double residual_cap = 12;  // mm: a larger distance only means that there is no partner
constexpr double least_scale = 0.1;  // mm: smaller differences are noise of the meshes
constexpr double same_angle = 0.2;   // rad

double largest_motion(const RigidTransform& step, std::span<const Match> matches) {
  double largest2 = 0;
  for (const Match& m : matches) largest2 = std::max(largest2, (step * m.moving - m.moving).squaredNorm());
  return std::sqrt(largest2);
}

}  // namespace

std::vector<Match> matches_of(std::span<const OrientedPoint> samples, const IndexedPoints& targets,
                              const RigidTransform& at) {
  std::vector<Match> matches;
  matches.reserve(samples.size());
  for (const OrientedPoint& sample : samples) {
    const OrientedPoint here = moved(sample, at);
    const NearPoint near = targets.nearest(here);
    const OrientedPoint& there = targets[near.index];
    matches.push_back(
        {here.position, there.position, mean_normal(here.normal, there.normal), near.distance()});
  }
  return matches;
}

double mean_residual(std::span<const Match> matches) {
  double sum = 0;
  for (const Match& m : matches) sum += std::min(m.distance, residual_cap);
  return sum / static_cast<double>(matches.size());
}

Pose descend(const Pose& start, const Matching& matching, const DescentOptions& options,
             const RunContext& ctx) {
  Pose pose = start;
  pose.converged = false;
  for (int k = 0; k < options.iteration_limit && !pose.converged; ++k) {
    ctx.check();
    const std::vector<Match> matches = matching(pose.at);
    const double length = 1.0 / std::max(1, k - options.full_steps + 1);
    const RigidTransform step = rigid_step(matches, tukey_weights(matches, least_scale), {.length = length});
    pose.at = step * pose.at;
    ++pose.iterations;
    pose.converged = largest_motion(step, matches) <= options.tolerance;
  }
  pose.residual = mean_residual(matching(pose.at));
  return pose;
}

void sort_best_first(std::vector<Pose>& poses) {
  std::stable_sort(poses.begin(), poses.end(),
                   [](const Pose& a, const Pose& b) { return a.residual < b.residual; });
}

bool same_answer(const Pose& a, const Pose& b) {
  return Eigen::AngleAxisd(a.at.linear() * b.at.linear().transpose()).angle() < same_angle;
}

std::vector<Pose> distinct_answers(std::span<const Pose> poses, int most) {
  std::vector<Pose> answers;
  for (const Pose& p : poses) {
    if (static_cast<int>(answers.size()) == most) break;
    if (std::none_of(answers.begin(), answers.end(), [&](const Pose& a) { return same_answer(a, p); }))
      answers.push_back(p);
  }
  return answers;
}

}  // namespace foramen::detail
