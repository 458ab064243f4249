#include "foramen/match/align_part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "core/parallel.hpp"
#include "foramen/core/error.hpp"
#include "match/oriented_points.hpp"
#include "match/rigid_descent.hpp"

namespace foramen {
namespace {

using detail::Pose;

constexpr int targets_on_whole = 10000;
constexpr double anchor_depth = 0.5;  // position of anchors between the centroid of the whole and its surface
constexpr std::uint64_t part_seed = 1, whole_seed = 2;

// A round of the search: number of poses that are continued, of iterations and of samples.
struct Round {
  int poses, iterations, samples;
};
constexpr Round rounds[] = {
    {std::numeric_limits<int>::max(), 4, 80}, {150, 6, 150}, {40, 12, 300}, {12, 20, 600}};

// Evenly distributed rotations \cite alexa2022.
std::vector<Mat3> spread_rotations(int count) {
  constexpr double phi = std::numbers::sqrt2, psi = 1.533751168755204288118041;
  std::vector<Mat3> rotations;
  for (int i = 0; i < count; ++i) {
    const double s = i + 0.5, t = s / count;
    const double alpha = 2 * std::numbers::pi * s / phi, beta = 2 * std::numbers::pi * s / psi;
    const double r = std::sqrt(t), q = std::sqrt(1 - t);
    rotations.push_back(
        Eigen::Quaterniond(r * std::sin(alpha), r * std::cos(alpha), q * std::sin(beta), q * std::cos(beta))
            .normalized()
            .toRotationMatrix());
  }
  return rotations;
}

// The centroid, and points halfway between it and surface points that are far from it and from each other
// (farthest-point sampling).
std::vector<Vec3> spread_anchors(const std::vector<OrientedPoint>& points, const Vec3& centroid, int count) {
  std::vector<Vec3> anchors{centroid};
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  Vec3 last = centroid;
  while (static_cast<int>(anchors.size()) < count) {
    for (std::size_t i = 0; i < points.size(); ++i)
      distance[i] = std::min(distance[i], (points[i].position - last).squaredNorm());
    const auto farthest = std::max_element(distance.begin(), distance.end()) - distance.begin();
    last = points[farthest].position;
    anchors.push_back(centroid + anchor_depth * (last - centroid));
  }
  return anchors;
}

class PartSearch {
 public:
  PartSearch(const Mesh& part, const Mesh& whole, const AlignPartOptions& options, const RunContext& ctx)
      : options_(options),
        ctx_(ctx),
        targets_(oriented_samples(whole, targets_on_whole, whole_seed), options.normal_weight),
        part_(part),
        part_normals_(vertex_normals(part)),
        whole_(whole) {}

  std::vector<Pose> run() const {
    std::vector<Pose> poses = starts();
    for (const Round& round : rounds) {
      if (static_cast<int>(poses.size()) > round.poses) poses.resize(round.poses);
      follow(poses, samples_of_part(round.samples), round.iterations);
    }
    poses = detail::distinct_answers(poses, options_.most_answers);
    follow(poses, samples_of_part(options_.sample_points), options_.iteration_limit);
    return detail::distinct_answers(poses);
  }

 private:
  std::vector<OrientedPoint> samples_of_part(int count) const {
    return oriented_samples(part_, part_normals_, count, part_seed);
  }

  std::vector<Pose> starts() const {
    const Vec3 from = surface_centroid(part_);
    const std::vector<Vec3> anchors =
        spread_anchors(targets_.points(), surface_centroid(whole_), options_.anchors);
    std::vector<Pose> all;
    for (const Mat3& rotation : spread_rotations(options_.rotations))
      for (const Vec3& anchor : anchors) {
        Pose start;
        start.at.linear() = rotation;
        start.at.translation() = anchor - rotation * from;
        all.push_back(start);
      }
    return all;
  }

  // Continues all poses by some iterations and sorts them, best first.
  void follow(std::vector<Pose>& poses, const std::vector<OrientedPoint>& samples, int iterations) const {
    const auto matching = [&](const RigidTransform& at) { return detail::matches_of(samples, targets_, at); };
    const detail::DescentOptions options{.iteration_limit = iterations, .tolerance = options_.tolerance};
    parallel_for(static_cast<int>(poses.size()), ctx_, [&](int i) {
      Pose& pose = poses[i];
      pose = detail::descend(pose, matching, options, ctx_);
    });
    detail::sort_best_first(poses);
  }

  const AlignPartOptions& options_;
  RunContext ctx_;
  IndexedPoints targets_;
  const Mesh& part_;
  VertexMap<Vec3> part_normals_;
  const Mesh& whole_;
};

}  // namespace

std::vector<Alignment> align_part(const Mesh& part, const Mesh& whole, const RunContext& ctx,
                                  const AlignPartOptions& options) {
  check_options("align_part", options);
  const std::vector<Pose> found = PartSearch(part, whole, options, ctx).run();
  std::vector<Alignment> answers;
  for (std::size_t i = 0; i < found.size(); ++i) {
    Alignment answer;
    answer.transform = found[i].at;
    answer.residual = found[i].residual;
    answer.second_best =
        i + 1 < found.size() ? found[i + 1].residual : std::numeric_limits<double>::infinity();
    answer.iterations = found[i].iterations;
    answer.converged = found[i].converged;
    answers.push_back(answer);
  }
  return answers;
}

}  // namespace foramen
