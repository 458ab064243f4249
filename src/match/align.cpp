#include "foramen/match/align.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "foramen/core/error.hpp"
#include "foramen/match/oriented_points.hpp"
#include "match/principal_frame.hpp"
#include "match/rigid_step.hpp"

namespace foramen {
namespace {

using detail::Match;

constexpr int coarse_samples = 400;  // a side: enough to tell a right start from a wrong one
constexpr int coarse_targets = 3000;
constexpr int least_targets = 10000;  // of the fine iterations
constexpr int finalists = 4;          // starts that are followed further
constexpr double residual_cap = 12;   // mm: beyond it a match says no more than that there is none
constexpr double least_scale = 0.1;   // mm: below it differences are noise of the meshes
constexpr int full_steps = 30;      // matches can go round in a cycle: later steps shrink, which averages it
constexpr double same_angle = 0.2;  // rad: closer rotations are the same answer
constexpr std::uint64_t sample_seed = 1, target_seed = 2;

// The vertices, or samples where these would lie so far apart that their spacing counted as a difference of
// the shapes.
std::vector<OrientedPoint> dense_points(const Mesh& mesh, const VertexMap<Vec3>& normals) {
  if (mesh.vertex_count() < least_targets) return oriented_samples(mesh, normals, least_targets, target_seed);
  return oriented_vertices(mesh, normals);
}

/// What one shape brings to the matching: samples that look for a partner, and targets among which the
/// other's find theirs.
struct Side {
  std::vector<OrientedPoint> samples;
  IndexedPoints targets;
};

std::vector<Match> matches(const Side& moving, const Side& fixed, const RigidTransform& at) {
  const RigidTransform back = at.inverse();
  std::vector<Match> all;
  all.reserve(moving.samples.size() + fixed.samples.size());
  for (const OrientedPoint& sample : moving.samples) {
    const OrientedPoint here = moved(sample, at);
    const NearPoint near = fixed.targets.nearest(here);
    const OrientedPoint& there = fixed.targets[near.index];
    all.push_back({here.position, there.position, mean_normal(here.normal, there.normal), near.distance()});
  }
  for (const OrientedPoint& there : fixed.samples) {
    const NearPoint near = moving.targets.nearest(moved(there, back));
    const OrientedPoint here = moved(moving.targets[near.index], at);
    all.push_back({here.position, there.position, mean_normal(here.normal, there.normal), near.distance()});
  }
  return all;
}

double residual(const Side& moving, const Side& fixed, const RigidTransform& at) {
  double sum = 0;
  const std::vector<Match> all = matches(moving, fixed, at);
  for (const Match& m : all) sum += std::min(m.distance, residual_cap);
  return sum / static_cast<double>(all.size());
}

double largest_motion(const RigidTransform& step, const std::vector<Match>& all) {
  double largest2 = 0;
  for (const Match& m : all) largest2 = std::max(largest2, (step * m.moving - m.moving).squaredNorm());
  return std::sqrt(largest2);
}

struct Candidate {
  RigidTransform at;
  double residual = std::numeric_limits<double>::infinity();
};

bool better(const Candidate& a, const Candidate& b) { return a.residual < b.residual; }

bool same_answer(const Candidate& a, const Candidate& b) {
  return Eigen::AngleAxisd(a.at.linear() * b.at.linear().transpose()).angle() < same_angle;
}

struct Descent {
  RigidTransform at;
  int iterations = 0;
  bool converged = false;
};

Descent descend(const Side& moving, const Side& fixed, const RigidTransform& start, int limit,
                double tolerance, const RunContext& ctx) {
  Descent state{start};
  while (state.iterations < limit && !state.converged) {
    ctx.check();
    const std::vector<Match> all = matches(moving, fixed, state.at);
    const double length = 1.0 / std::max(1, state.iterations - full_steps + 1);
    const RigidTransform step =
        detail::rigid_step(all, detail::tukey_weights(all, least_scale), {.length = length});
    state.at = step * state.at;
    ++state.iterations;
    state.converged = largest_motion(step, all) <= tolerance;
  }
  return state;
}

// All starts, followed by a few iterations each; the best few distinct ones by some more. Best first.
std::vector<Candidate> coarse_search(const Side& moving, const Side& fixed, const Mesh& moving_mesh,
                                     const Mesh& fixed_mesh, const AlignOptions& options,
                                     const RunContext& ctx) {
  const detail::PrincipalFrame from = detail::principal_frame(moving_mesh),
                               to = detail::principal_frame(fixed_mesh);
  const auto follow = [&](const RigidTransform& start, int iterations) {
    const RigidTransform at = descend(moving, fixed, start, iterations, options.tolerance, ctx).at;
    return Candidate{at, residual(moving, fixed, at)};
  };
  std::vector<Candidate> candidates;
  for (const Mat3& matching : detail::proper_matchings()) {
    RigidTransform start = RigidTransform::Identity();
    start.linear() = to.axes * matching * from.axes.transpose();
    start.translation() = to.centre - start.linear() * from.centre;
    candidates.push_back(follow(start, options.coarse_iterations));
  }
  std::stable_sort(candidates.begin(), candidates.end(), better);
  std::vector<Candidate> distinct;
  for (const Candidate& c : candidates)
    if (std::none_of(distinct.begin(), distinct.end(), [&](const Candidate& d) { return same_answer(c, d); }))
      distinct.push_back(c);
  const std::size_t followed = std::min<std::size_t>(finalists, distinct.size());
  for (std::size_t i = 0; i < followed; ++i)
    distinct[i] = follow(distinct[i].at, 2 * options.coarse_iterations);
  std::stable_sort(distinct.begin(), distinct.end(), better);
  return distinct;
}

void check(const AlignOptions& options) {
  const auto refuse = [](const std::string& what) { throw InvalidInput("align: " + what); };
  if (!(options.normal_weight >= 0)) refuse("normal_weight must be >= 0 mm");
  if (options.sample_points < 2)
    refuse("sample_points is " + std::to_string(options.sample_points) + "; it must be at least 2");
  if (options.coarse_iterations < 0 || options.iteration_limit < 0) refuse("iterations must be >= 0");
  if (!(options.tolerance >= 0)) refuse("tolerance must be >= 0 mm");
}

}  // namespace

Alignment align(const Mesh& moving, const Mesh& fixed, const RunContext& ctx, const AlignOptions& options) {
  check(options);
  const VertexMap<Vec3> moving_normals = vertex_normals(moving), fixed_normals = vertex_normals(fixed);
  const auto coarse_side = [&](const Mesh& mesh, const VertexMap<Vec3>& normals) {
    return Side{oriented_samples(mesh, normals, coarse_samples, sample_seed),
                {oriented_samples(mesh, normals, coarse_targets, target_seed), options.normal_weight}};
  };
  const auto fine_side = [&](const Mesh& mesh, const VertexMap<Vec3>& normals) {
    return Side{oriented_samples(mesh, normals, options.sample_points / 2, sample_seed),
                {dense_points(mesh, normals), options.normal_weight}};
  };
  const std::vector<Candidate> candidates = coarse_search(
      coarse_side(moving, moving_normals), coarse_side(fixed, fixed_normals), moving, fixed, options, ctx);

  const Side from = fine_side(moving, moving_normals), to = fine_side(fixed, fixed_normals);
  const Descent fine =
      descend(from, to, candidates.front().at, options.iteration_limit, options.tolerance, ctx);
  Alignment result;
  result.transform = fine.at;
  result.iterations = fine.iterations;
  result.converged = fine.converged;
  result.residual = residual(from, to, fine.at);
  const Candidate best{fine.at, result.residual};
  const auto other = std::find_if(candidates.begin() + 1, candidates.end(),
                                  [&](const Candidate& c) { return !same_answer(c, best); });
  result.second_best =
      other == candidates.end() ? std::numeric_limits<double>::infinity() : residual(from, to, other->at);
  return result;
}

}  // namespace foramen
