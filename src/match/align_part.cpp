#include "foramen/match/align_part.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/parallel.hpp"
#include "foramen/match/oriented_points.hpp"
#include "match/rigid_step.hpp"

namespace foramen {
namespace {

using detail::Match;

constexpr int targets_on_whole = 10000;
constexpr double residual_cap = 12;   // mm: beyond it a match says no more than that there is none
constexpr double least_scale = 0.1;   // mm: below it differences are noise of the meshes
constexpr double same_angle = 0.2;    // rad: closer rotations are the same answer
constexpr double anchor_depth = 0.5;  // anchors lie so far from the whole's centroid towards its surface
constexpr std::uint64_t part_seed = 1, whole_seed = 2;

// Rounds of the search: so many candidates, followed for so many iterations with so many samples.
struct Round {
  int candidates, iterations, samples;
};
constexpr Round rounds[] = {
    {std::numeric_limits<int>::max(), 4, 80}, {150, 6, 150}, {40, 12, 300}, {12, 20, 600}};

// Rotations spread evenly over all there are \cite alexa2022.
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

// The centroid, and points halfway from it to the places of the surface farthest from it and from each other.
std::vector<Vec3> spread_anchors(const std::vector<OrientedPoint>& points, const Vec3& centroid, int count) {
  std::vector<Vec3> anchors{centroid};
  std::vector<double> distance(points.size(), std::numeric_limits<double>::infinity());
  Vec3 last = centroid;
  while (static_cast<int>(anchors.size()) < count) {
    for (std::size_t i = 0; i < points.size(); ++i)
      distance[i] = std::min(distance[i], (points[i].position - last).squaredNorm());
    const auto farthest = std::max_element(distance.begin(), distance.end()) - distance.begin();
    last = points[static_cast<std::size_t>(farthest)].position;
    anchors.push_back(centroid + anchor_depth * (last - centroid));
  }
  return anchors;
}

struct Candidate {
  RigidTransform at = RigidTransform::Identity();
  double residual = std::numeric_limits<double>::infinity();
  int iterations = 0;
  bool converged = false;
};

class PartSearch {
 public:
  PartSearch(const Mesh& part, const Mesh& whole, const AlignPartOptions& options, const RunContext& ctx)
      : options_(options),
        ctx_(ctx),
        targets_(oriented_samples(whole, targets_on_whole, whole_seed), options.normal_weight),
        part_(part),
        part_normals_(vertex_normals(part)),
        whole_(whole) {}

  std::vector<Candidate> run() const {
    std::vector<Candidate> candidates = starts();
    for (const Round& round : rounds) {
      if (static_cast<int>(candidates.size()) > round.candidates)
        candidates.resize(static_cast<std::size_t>(round.candidates));
      follow(candidates, samples_of_part(round.samples), round.iterations);
    }
    candidates = distinct(std::move(candidates));
    follow(candidates, samples_of_part(options_.sample_points), options_.iteration_limit);
    return distinct(std::move(candidates));
  }

 private:
  std::vector<OrientedPoint> samples_of_part(int count) const {
    return oriented_samples(part_, part_normals_, count, part_seed);
  }

  std::vector<Candidate> starts() const {
    const Vec3 from = surface_centroid(part_);
    const std::vector<Vec3> anchors =
        spread_anchors(targets_.points(), surface_centroid(whole_), options_.anchors);
    std::vector<Candidate> all;
    for (const Mat3& rotation : spread_rotations(options_.rotations))
      for (const Vec3& anchor : anchors) {
        Candidate start;
        start.at.linear() = rotation;
        start.at.translation() = anchor - rotation * from;
        all.push_back(start);
      }
    return all;
  }

  std::vector<Match> matches(const std::vector<OrientedPoint>& samples, const RigidTransform& at) const {
    std::vector<Match> all;
    all.reserve(samples.size());
    for (const OrientedPoint& sample : samples) {
      const OrientedPoint here = moved(sample, at);
      const NearPoint near = targets_.nearest(here);
      const OrientedPoint& there = targets_[near.index];
      all.push_back({here.position, there.position, mean_normal(here.normal, there.normal), near.distance()});
    }
    return all;
  }

  // Moves every candidate on and sorts them, best first.
  void follow(std::vector<Candidate>& candidates, const std::vector<OrientedPoint>& samples,
              int iterations) const {
    parallel_for(static_cast<int>(candidates.size()), ctx_,
                 [&](int i) { descend(candidates[static_cast<std::size_t>(i)], samples, iterations); });
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.residual < b.residual; });
  }

  void descend(Candidate& state, const std::vector<OrientedPoint>& samples, int limit) const {
    state.converged = false;
    for (int k = 0; k < limit && !state.converged; ++k) {
      const std::vector<Match> all = matches(samples, state.at);
      const RigidTransform step = detail::rigid_step(all, detail::tukey_weights(all, least_scale));
      double largest = 0;
      for (const Match& m : all) largest = std::max(largest, (step * m.moving - m.moving).norm());
      state.at = step * state.at;
      ++state.iterations;
      state.converged = largest <= options_.tolerance;
    }
    state.residual = 0;
    for (const Match& m : matches(samples, state.at))
      state.residual += std::min(m.distance, residual_cap) / static_cast<double>(samples.size());
  }

  // The best of those that have about the same rotation; \pre sorted.
  std::vector<Candidate> distinct(std::vector<Candidate> sorted) const {
    std::vector<Candidate> answers;
    for (Candidate& c : sorted) {
      const bool known = std::any_of(answers.begin(), answers.end(), [&](const Candidate& a) {
        return Eigen::AngleAxisd(a.at.linear() * c.at.linear().transpose()).angle() < same_angle;
      });
      if (!known && static_cast<int>(answers.size()) < options_.most_answers) answers.push_back(c);
    }
    return answers;
  }

  const AlignPartOptions& options_;
  RunContext ctx_;
  IndexedPoints targets_;
  const Mesh& part_;
  VertexMap<Vec3> part_normals_;
  const Mesh& whole_;
};

void check(const AlignPartOptions& options) {
  const auto refuse = [](const std::string& what) { throw InvalidInput("align_part: " + what); };
  if (!(options.normal_weight >= 0)) refuse("normal_weight must be >= 0 mm");
  if (options.rotations < 1 || options.anchors < 1 || options.sample_points < 1 || options.most_answers < 1)
    refuse("rotations, anchors, sample_points and most_answers must be at least 1");
  if (options.iteration_limit < 0) refuse("iteration_limit must be >= 0");
  if (!(options.tolerance >= 0)) refuse("tolerance must be >= 0 mm");
}

}  // namespace

std::vector<Alignment> align_part(const Mesh& part, const Mesh& whole, const RunContext& ctx,
                                  const AlignPartOptions& options) {
  check(options);
  const std::vector<Candidate> found = PartSearch(part, whole, options, ctx).run();
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
