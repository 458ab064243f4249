#include "evaluate/closest_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "core/parallel.hpp"

namespace foramen::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Relative margin for rounding, by which a sum must exceed a number to count as larger.
constexpr double bound_margin = 1e-10;
// Samples that are expected to be far are measured first: those beyond these multiples of the average
// distance, in turn.
constexpr std::array<float, 4> first_those_beyond{1.5f, 1.0f, 0.5f, -1.0f};
constexpr int samples_between_looks = 32;

std::vector<std::size_t> ordered_by(const std::vector<double>& keys) {
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
  return order;
}

std::vector<MeasuredSurface> measured(const std::vector<Mesh>& meshes, int samples, std::uint64_t seed) {
  std::vector<MeasuredSurface> surfaces;
  surfaces.reserve(meshes.size());
  for (const Mesh& mesh : meshes) surfaces.emplace_back(mesh, samples, seed).settle();
  return surfaces;
}

}  // namespace

TrainingSurfaces::TrainingSurfaces(MeasuredSurface middle_surface, const std::vector<Mesh>& inputs,
                                   int samples, std::uint64_t seed, double reach, double spacing,
                                   const RunContext& ctx)
    : middle(std::move(middle_surface)),
      shapes(measured(inputs, samples, seed)),
      lattice(middle, shapes, reach, spacing, ctx),
      starts(inputs.size()),
      from_middle(inputs.size()) {
  parallel_for(static_cast<int>(inputs.size()), ctx, [&](int i) {
    const std::size_t s = i;
    hausdorff_distance(middle, shapes[s], infinity, starts[s]);
    for (const double d : sample_distances(shapes[s], middle))
      from_middle[s].push_back(static_cast<float>(d));
  });
}

ClosestShapeSearch::ClosestShapeSearch(const TrainingSurfaces& training)
    : training_(training), starts_(training.starts), expected_(training.from_middle) {}

void ClosestShapeSearch::look_at(const MeasuredSurface& probe) {
  probe_ = &probe;
  const std::size_t shapes = training_.shapes.size(), width = training_.lattice.width();
  bounds_.assign(probe.samples().size() * width, 0.0f);
  bound_sum_.assign(shapes, 0.0);
  bound_max_.assign(shapes, 0.0);
  for (std::size_t k = 0; k < probe.samples().size(); ++k) {
    const std::span<float> bounds(bounds_.data() + k * width, width);
    if (!training_.lattice.lower_bounds(probe.samples()[k], bounds)) continue;
    for (std::size_t i = 0; i < shapes; ++i) {
      const auto d = static_cast<double>(bounds[i]);
      bound_sum_[i] += d;
      bound_max_[i] = std::max(bound_max_[i], d);
    }
  }
}

double ClosestShapeSearch::smallest_hausdorff(const std::function<double(std::size_t)>& needed,
                                              const std::function<void(std::size_t, double)>& found) {
  double smallest = infinity;
  for (const std::size_t i : ordered_by(bound_max_)) {
    const double give_up = std::max(smallest, needed(i));
    if (bound_max_[i] > give_up) continue;
    const double d =
        hausdorff_distance(*probe_, training_.shapes[i], give_up, starts_[i], 0, {&training_.lattice, i});
    if (d > give_up) continue;
    smallest = std::min(smallest, d);
    found(i, d);
  }
  return smallest;
}

double ClosestShapeSearch::smallest_mean() {
  double smallest = infinity;
  for (const std::size_t i : ordered_by(bound_sum_))
    smallest = std::min(smallest, mean_or_beyond(i, smallest));
  return smallest;
}

/// The mean distance to a shape; infinity if it certainly exceeds `smallest`.
double ClosestShapeSearch::mean_or_beyond(std::size_t shape, double smallest) {
  // The limit for the sum of all distances in both directions. In the sum below, a distance that is not yet
  // measured is replaced by its lower bound.
  const double enough = 2 * smallest * static_cast<double>(probe_->samples().size()) * (1 + bound_margin);
  if (bound_sum_[shape] > enough || backward_bound_beyond(shape, enough - bound_sum_[shape])) return infinity;

  const MeasuredSurface& other = training_.shapes[shape];
  const std::vector<double> backward = sample_distances(other, *probe_);
  std::transform(backward.begin(), backward.end(), expected_[shape].begin(),
                 [](double d) { return static_cast<float>(d); });
  double at_least = bound_sum_[shape] + std::accumulate(backward.begin(), backward.end(), 0.0);
  std::vector<double> forward(probe_->samples().size());
  for (std::size_t k = 0; k < forward.size(); ++k) {
    if (k % samples_between_looks == 0 && at_least > enough) return infinity;
    forward[k] = std::sqrt(other.tree().squared_distance(probe_->samples()[k]));
    at_least += forward[k] - static_cast<double>(bounds_[k * training_.lattice.width() + shape]);
  }
  return 0.5 * (mean_of(forward) + mean_of(backward));
}

/// Whether the distances of the shape's samples to the probe certainly sum to more than `sum`.
bool ClosestShapeSearch::backward_bound_beyond(std::size_t shape, double sum) {
  if (sum == infinity) return false;
  const auto samples = training_.shapes[shape].samples();
  std::vector<float>& expected = expected_[shape];
  const float average =
      std::accumulate(expected.begin(), expected.end(), 0.0f) / static_cast<float>(expected.size());
  std::vector<float> now = expected;
  double at_least = 0;
  float up_to = std::numeric_limits<float>::infinity();
  int since = 0;
  bool beyond = false;
  for (std::size_t part = 0; part < first_those_beyond.size() && !beyond; ++part) {
    const float down_to = first_those_beyond[part] * average;
    for (std::size_t k = 0; k < samples.size() && !beyond; ++k) {
      if (!(expected[k] > down_to) || expected[k] > up_to) continue;
      const double d = probe_->tree().distance_at_least(samples[k]);
      at_least += d;
      now[k] = static_cast<float>(d);
      if (++since % samples_between_looks == 0) beyond = at_least > sum;
    }
    up_to = down_to;
  }
  expected = std::move(now);
  return beyond || at_least > sum;
}

}  // namespace foramen::detail
