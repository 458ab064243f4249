#include "foramen/apply/complete_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "foramen/apply/posterior.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/match/oriented_points.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {
namespace {

constexpr int targets_on_part = 10000;
constexpr std::uint64_t sample_seed = 1, target_seed = 2;
// The pose about the last one: wide beside what an iteration moves.
constexpr double shift_mm = 10, turn_rad = 0.3, log_size = 0.1;

// The fit of the modes, from coarse to fine, then with the smooth part as well.
constexpr double coarse_noise_mm[] = {4, 2, 1};
constexpr int coarse_iterations = 6, fine_iterations = 8, smooth_iterations = 6;

SimilarityTransform composed(const SimilarityTransform& second, const SimilarityTransform& first) {
  return {second.scale * first.scale, second.rotation * first.rotation, second(first.translation)};
}

OrientedPoint moved(const OrientedPoint& p, const SimilarityTransform& by) {
  return {by(p.position), by.rotation * p.normal, p.at_border};
}

/// Where the fit is: the pose, and the shape in model coordinates.
struct State {
  SimilarityTransform to_model;
  Eigen::VectorXd shape;
};

/// One set of matches, and what follows from it.
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
        samples_(oriented_samples(part, options.samples, sample_seed)),
        targets_(oriented_samples(part, targets_on_part, target_seed), options.normal_weight),
        area_per_sample_(total_area(part) / options.samples) {}

  /// From one pose, the modes alone.
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

  /// The end of the fit: the distribution in the part's coordinates.
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

  /// Mean distance of the part's samples to a shape, mm.
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

  /// Translation, rotation about the centroid, and with ScaleMode::remove size, times their prior's
  /// deviation.
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

  /// The motion of the model that those columns stand for.
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
    const IndexedPoints landmarks(oriented_vertices(shape), options_.normal_weight);
    std::vector<OrientedPoint> samples;
    for (const OrientedPoint& p : samples_) samples.push_back(moved(p, state.to_model));
    Matches result;
    result.seen.assign(static_cast<std::size_t>(shape.vertex_count()), false);

    std::vector<NearPoint> near;
    std::vector<double> distances;
    for (const OrientedPoint& p : samples) {
      near.push_back(landmarks.nearest(p));
      distances.push_back(near.back().distance());
    }
    std::vector<double> sorted = distances;
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    const double cut = options_.rejection * std::max(*middle, options_.least_median_mm);
    const auto take = [&](int landmark, const OrientedPoint& on_part, double distance, double area) {
      if (distance >= cut) return false;
      result.observations.push_back(
          {landmark, on_part.position,
           precision(landmarks[landmark].normal, on_part.normal, distance / cut, area, noise)});
      result.seen[static_cast<std::size_t>(landmark)] = true;
      return true;
    };
    int matched = 0;
    for (std::size_t i = 0; i < samples.size(); ++i)
      if (take(near[i].index, samples[i], distances[i], area_per_sample_)) ++matched;
    result.matched_share = static_cast<double>(matched) / static_cast<double>(samples.size());

    const SimilarityTransform back = state.to_model.inverse();
    const VertexMap<double> areas = vertex_areas(shape);
    for (VertexId v : shape.vertices()) {
      const NearPoint partner = targets_.nearest(moved(landmarks[v.index], back));
      const OrientedPoint& target = targets_[partner.index];
      if (!target.at_border)
        take(v.index, moved(target, state.to_model), state.to_model.scale * partner.distance(), areas[v]);
    }
    return result;
  }

  Mat3 precision(const Vec3& landmark_normal, const Vec3& part_normal, double ratio, double area,
                 double noise) const {
    const double tukey = (1 - ratio * ratio) * (1 - ratio * ratio);
    // Half: both surfaces bring their matches.
    const double weight = tukey * area / options_.independent_area_mm2 / (2 * noise * noise);
    const Vec3 normal = mean_normal(landmark_normal, part_normal);
    return weight * ((1 - options_.tangential_share) * normal * normal.transpose() +
                     options_.tangential_share * Mat3::Identity());
  }

  const CompleteSurfaceOptions& options_;
  Mesh mean_mesh_;
  std::vector<OrientedPoint> samples_;
  IndexedPoints targets_;
  double area_per_sample_;
};

void check(const CompleteSurfaceOptions& options) {
  const auto refuse = [](const std::string& what) { throw InvalidInput("complete_surface: " + what); };
  if (!(options.noise_mm > 0)) refuse("noise_mm must be > 0");
  if (!(options.independent_area_mm2 > 0 && options.rejection > 0 && options.least_median_mm > 0))
    refuse("independent_area_mm2, rejection and least_median_mm must be > 0");
  if (!(options.tangential_share > 0 && options.tangential_share <= 1))
    refuse("tangential_share must be in (0, 1]");
  if (!(options.normal_weight >= 0)) refuse("normal_weight must be >= 0 mm");
  if (options.samples < 1) refuse("samples must be at least 1");
  if (!(options.beyond_modes >= 0)) refuse("beyond_modes must be >= 0");
}

}  // namespace

CompletedSurface complete_surface(const Mesh& part, const ShapeModel& model, const RunContext& ctx,
                                  const CompleteSurfaceOptions& options) {
  check(options);
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
