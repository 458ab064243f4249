#include "foramen/apply/complete_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "apply/posterior.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "match/oriented_points.hpp"
#include "match/vertex_matches.hpp"
#include "spatial/point_index.hpp"

namespace foramen {
namespace {

constexpr int targets_on_part = 10000;
constexpr std::uint64_t sample_seed = 1, target_seed = 2;
// Standard deviations of the pose relative to the previous one; large compared with the motion in one
// iteration.
constexpr double shift_mm = 10, turn_rad = 0.3, log_size = 0.1;

// The noise levels and iterations of the fit: first the modes only, from coarse to fine, then with the smooth
// part.
constexpr double coarse_noise_mm[] = {4, 2, 1};
constexpr int coarse_iterations = 6, fine_iterations = 8, smooth_iterations = 6;

SimilarityTransform composed(const SimilarityTransform& second, const SimilarityTransform& first) {
  return {second.scale * first.scale, second.rotation * first.rotation, second(first.translation)};
}

OrientedPoint moved(const OrientedPoint& p, const SimilarityTransform& by) {
  return {by(p.position), by.rotation * p.normal, p.at_border};
}

/// The state of the fit: the pose, and the shape in model coordinates.
struct State {
  SimilarityTransform to_model;
  Eigen::VectorXd shape;
};

/// One set of matches and the observations that follow from it.
struct Matches {
  std::vector<LandmarkObservation> observations;
  std::vector<bool> seen;    // per landmark
  double matched_share = 0;  // of the part's samples
};

class PartFit {
 public:
  PartFit(const Mesh& part, const ShapeModel& model, const CompleteSurfaceOptions& options)
      : options_(options),
        mean_mesh_(build_mesh({unflattened(model.mean()), model.triangles()})),
        samples_(oriented_samples(part, options.match.samples, sample_seed)),
        targets_(oriented_samples(part, targets_on_part, target_seed), options.match.normal_weight),
        area_per_sample_(total_area(part) / options.match.samples) {}

  /// Fits the modes only, starting from one pose.
  State fit_from(const RigidTransform& pose, const ShapeDistribution& modes, const RunContext& ctx) const {
    State state{{1, pose.linear(), pose.translation()}, modes.mean};
    for (const double noise : coarse_noise_mm)
      if (noise > options_.noise_mm) state = improved(state, modes, noise, coarse_iterations, ctx);
    return improved(state, modes, options_.noise_mm, fine_iterations, ctx);
  }

  State improved(State state, const ShapeDistribution& prior, double noise, int iterations,
                 const RunContext& ctx) const {
    for (int k = 0; k < iterations; ++k) {
      ctx.check();
      const Eigen::MatrixXd pose = pose_columns(state.shape);
      const ShapeDistribution all = with_columns(prior, pose);
      const Matches found = matches(state, noise);
      const PosteriorCoefficients given = posterior_coefficients(all, found.observations);
      const Eigen::Index shapes = prior.factor.cols();
      const Vec3 centre = centroid(state.shape);
      state.shape = prior.mean + prior.factor * given.mean.head(shapes);
      state.to_model = composed(motion(given.mean.tail(pose.cols()), centre).inverse(), state.to_model);
    }
    return state;
  }

  /// The final distribution in the coordinates of the part.
  CompletedSurface finished(const State& state, const ShapeDistribution& prior) const {
    const ShapeDistribution all = with_columns(prior, pose_columns(state.shape));
    const Matches found = matches(state, options_.noise_mm);
    CompletedSurface result;
    result.to_model = state.to_model;
    result.shape = posterior(all, posterior_coefficients(all, found.observations));
    result.seen = found.seen;
    result.matched_share = found.matched_share;
    const SimilarityTransform back = state.to_model.inverse();
    for (int i = 0; i < result.shape.landmarks(); ++i) {
      result.shape.mean.segment<3>(3 * i) = back(result.shape.mean.segment<3>(3 * i));
      result.shape.factor.middleRows<3>(3 * i) =
          (back.scale * back.rotation * result.shape.factor.middleRows<3>(3 * i)).eval();
    }
    return result;
  }

  /// Mean distance of the samples of the part to the shape, mm.
  double distance(const State& state) const {
    const TriangleTree tree(mean_mesh_.with_positions(unflattened(state.shape)));
    double sum = 0;
    for (const OrientedPoint& p : samples_)
      sum += std::sqrt(tree.closest(state.to_model(p.position)).squared_distance);
    return sum / static_cast<double>(samples_.size());
  }

 private:
  static Vec3 centroid(const Eigen::VectorXd& shape) {
    return Eigen::Map<const Eigen::Matrix3Xd>(shape.data(), 3, shape.size() / 3).rowwise().mean();
  }

  /// Columns for translation, rotation about the centroid and, with ScaleMode::remove, size, each times the
  /// standard deviation of its prior.
  Eigen::MatrixXd pose_columns(const Eigen::VectorXd& shape) const {
    const Vec3 centre = centroid(shape);
    Eigen::MatrixXd columns(shape.size(), options_.scale == ScaleMode::remove ? 7 : 6);
    for (Eigen::Index i = 0; i < shape.size() / 3; ++i) {
      const Vec3 arm = shape.segment<3>(3 * i) - centre;
      columns.block<3, 3>(3 * i, 0) = shift_mm * Mat3::Identity();
      for (int k = 0; k < 3; ++k)
        columns.block<3, 1>(3 * i, 3 + k) = turn_rad * Vec3(Vec3::Unit(k)).cross(arm);
      if (columns.cols() == 7) columns.block<3, 1>(3 * i, 6) = log_size * arm;
    }
    return columns;
  }

  /// The motion of the model for coefficients of these columns.
  static SimilarityTransform motion(const Eigen::VectorXd& pose, const Vec3& centre) {
    SimilarityTransform result;
    if (pose.size() == 7) result.scale = std::exp(log_size * pose[6]);
    const Vec3 turn = turn_rad * pose.segment<3>(3);
    if (turn.norm() > 0)
      result.rotation = Eigen::AngleAxisd(turn.norm(), turn.normalized()).toRotationMatrix();
    result.translation = centre + shift_mm * pose.head<3>() - result.scale * (result.rotation * centre);
    return result;
  }

  Matches matches(const State& state, double noise) const {
    const Mesh shape = mean_mesh_.with_positions(unflattened(state.shape));
    const IndexedPoints landmarks(oriented_vertices(shape), options_.match.normal_weight);
    std::vector<VertexMatch> all = matches_of_samples(landmarks, state.to_model);
    // The cut uses the matches of the part's samples only. Landmarks that the part does not contain are far
    // from it, so the median of all matches would be too large.
    const MatchScale scale{.noise_mm = noise, .cut_mm = match_cut(all, options_.match)};
    const auto taken = [&](const VertexMatch& m) { return m.distance < scale.cut_mm; };
    Matches result;
    result.matched_share =
        static_cast<double>(std::count_if(all.begin(), all.end(), taken)) / static_cast<double>(all.size());

    const std::vector<VertexMatch> of_landmarks = matches_of_landmarks(shape, landmarks, state.to_model);
    all.insert(all.end(), of_landmarks.begin(), of_landmarks.end());
    result.seen.assign(landmarks.points().size(), false);
    for (const VertexMatch& m : all) {
      if (!taken(m)) continue;
      result.observations.push_back(
          {m.vertex, m.partner.position, match_precision(m, landmarks[m.vertex], scale, options_.match)});
      result.seen[m.vertex] = true;
    }
    return result;
  }

  /// The matches of the part's samples, in model coordinates.
  std::vector<VertexMatch> matches_of_samples(const IndexedPoints& landmarks,
                                              const SimilarityTransform& to_model) const {
    std::vector<VertexMatch> matches;
    for (const OrientedPoint& sample : samples_) {
      const OrientedPoint here = moved(sample, to_model);
      const NearPoint near = landmarks.nearest(here);
      matches.push_back({near.index, here, near.distance(), area_per_sample_});
    }
    return matches;
  }

  std::vector<VertexMatch> matches_of_landmarks(const Mesh& shape, const IndexedPoints& landmarks,
                                                const SimilarityTransform& to_model) const {
    const SimilarityTransform back = to_model.inverse();
    const VertexMap<double> areas = vertex_areas(shape);
    std::vector<VertexMatch> matches;
    for (VertexId v : shape.vertices()) {
      const NearPoint near = targets_.nearest(moved(landmarks[v.index], back));
      const OrientedPoint& target = targets_[near.index];
      if (!target.at_border)
        matches.push_back({v.index, moved(target, to_model), to_model.scale * near.distance(), areas[v]});
    }
    return matches;
  }

  const CompleteSurfaceOptions& options_;
  Mesh mean_mesh_;
  std::vector<OrientedPoint> samples_;
  IndexedPoints targets_;
  double area_per_sample_;
};
}  // namespace

CompletedSurface complete_surface(const Mesh& part, const ShapeModel& model, const RunContext& ctx,
                                  const CompleteSurfaceOptions& options) {
  check_options("complete_surface", options);
  const Mesh mean = build_mesh({unflattened(model.mean()), model.triangles()});
  const std::vector<Alignment> poses = align_part(part, mean, ctx, options.pose);
  const PartFit fit(part, model, options);
  ShapeDistribution prior = distribution_of(model);

  State best;
  double least = std::numeric_limits<double>::infinity(), second = least;
  for (const Alignment& pose : poses) {
    State state = fit.fit_from(pose.transform, prior, ctx);
    const double distance = fit.distance(state);
    second = std::min(second, std::max(least, distance));
    if (distance < least) {
      least = distance;
      best = std::move(state);
    }
  }
  if (options.beyond_modes > 0) {
    prior =
        with_columns(std::move(prior), smooth_columns(model.mean(), options.beyond_modes, options.smooth));
    best = fit.improved(std::move(best), prior, options.noise_mm, smooth_iterations, ctx);
  }
  CompletedSurface result = fit.finished(best, prior);
  result.distance_mm = fit.distance(best);
  result.second_best_mm = second;
  return result;
}

}  // namespace foramen
