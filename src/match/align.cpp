#include "foramen/match/align.hpp"

#include <algorithm>
#include <limits>
#include <string>

#include "foramen/core/error.hpp"
#include "match/oriented_points.hpp"
#include "match/principal_frame.hpp"
#include "match/rigid_descent.hpp"
#include "spatial/point_index.hpp"

namespace foramen {
namespace {

using detail::Match;
using detail::Pose;

constexpr int coarse_samples = 400;  // per shape: enough to distinguish a correct start from a wrong one
constexpr int coarse_targets = 3000;
constexpr int least_targets = 10000;  // number of targets in the fine iterations
constexpr int finalists = 4;          // number of starts that are continued
constexpr int full_steps = 30;        // see DescentOptions
constexpr std::uint64_t sample_seed = 1, target_seed = 2;

// The vertices of a mesh. A coarse mesh is represented by samples, because the distances between its vertices
// would count as differences of the shapes.
std::vector<OrientedPoint> dense_points(const Mesh& mesh, const VertexMap<Vec3>& normals) {
  if (mesh.vertex_count() < least_targets) return oriented_samples(mesh, normals, least_targets, target_seed);
  return oriented_vertices(mesh, normals);
}

/// One shape in the matching: samples for which partners are sought on the other shape, and targets among
/// which the samples of the other shape find their partners.
struct Side {
  std::vector<OrientedPoint> samples;
  IndexedPoints targets;
};

std::vector<Match> matches(const Side& moving, const Side& fixed, const RigidTransform& at) {
  const RigidTransform back = at.inverse();
  std::vector<Match> all = detail::matches_of(moving.samples, fixed.targets, at);
  for (const OrientedPoint& there : fixed.samples) {
    const NearPoint near = moving.targets.nearest(moved(there, back));
    const OrientedPoint here = moved(moving.targets[near.index], at);
    all.push_back({here.position, there.position, mean_normal(here.normal, there.normal), near.distance()});
  }
  return all;
}

Pose descent(const Side& moving, const Side& fixed, const RigidTransform& start, int iterations,
             const AlignOptions& options, const RunContext& ctx) {
  return detail::descend(
      {.at = start}, [&](const RigidTransform& at) { return matches(moving, fixed, at); },
      {.iteration_limit = iterations, .tolerance = options.tolerance, .full_steps = full_steps}, ctx);
}

// Runs a few iterations from all starts and some more from the best few distinct poses. Best first.
std::vector<Pose> coarse_search(const Side& moving, const Side& fixed, const Mesh& moving_mesh,
                                const Mesh& fixed_mesh, const AlignOptions& options, const RunContext& ctx) {
  const detail::PrincipalFrame from = detail::principal_frame(moving_mesh),
                               to = detail::principal_frame(fixed_mesh);
  const auto follow = [&](const RigidTransform& start, int iterations) {
    return descent(moving, fixed, start, iterations, options, ctx);
  };
  std::vector<Pose> poses;
  for (const Mat3& matching : detail::proper_matchings()) {
    RigidTransform start = RigidTransform::Identity();
    start.linear() = to.axes * matching * from.axes.transpose();
    start.translation() = to.centre - start.linear() * from.centre;
    poses.push_back(follow(start, options.coarse_iterations));
  }
  detail::sort_best_first(poses);
  poses = detail::distinct_answers(poses);
  const std::size_t followed = std::min<std::size_t>(finalists, poses.size());
  for (std::size_t i = 0; i < followed; ++i) poses[i] = follow(poses[i].at, 2 * options.coarse_iterations);
  detail::sort_best_first(poses);
  return poses;
}

}  // namespace

Alignment align(const Mesh& moving, const Mesh& fixed, const RunContext& ctx, const AlignOptions& options) {
  check_options("align", options);
  const VertexMap<Vec3> moving_normals = vertex_normals(moving), fixed_normals = vertex_normals(fixed);
  const auto coarse_side = [&](const Mesh& mesh, const VertexMap<Vec3>& normals) {
    return Side{oriented_samples(mesh, normals, coarse_samples, sample_seed),
                {oriented_samples(mesh, normals, coarse_targets, target_seed), options.normal_weight}};
  };
  const auto fine_side = [&](const Mesh& mesh, const VertexMap<Vec3>& normals) {
    return Side{oriented_samples(mesh, normals, options.sample_points / 2, sample_seed),
                {dense_points(mesh, normals), options.normal_weight}};
  };
  const std::vector<Pose> poses = coarse_search(
      coarse_side(moving, moving_normals), coarse_side(fixed, fixed_normals), moving, fixed, options, ctx);

  const Side from = fine_side(moving, moving_normals), to = fine_side(fixed, fixed_normals);
  const Pose best = descent(from, to, poses.front().at, options.iteration_limit, options, ctx);
  const auto other = std::find_if(poses.begin() + 1, poses.end(),
                                  [&](const Pose& p) { return !detail::same_answer(p, best); });
  Alignment result;
  result.transform = best.at;
  result.residual = best.residual;
  result.second_best = other == poses.end() ? std::numeric_limits<double>::infinity()
                                            : detail::mean_residual(matches(from, to, other->at));
  result.iterations = best.iterations;
  result.converged = best.converged;
  return result;
}

}  // namespace foramen
