#include "synth/rough_motions.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "foramen/core/geometry.hpp"
#include "synth/solids.hpp"
#include "synth/vertebra_features.hpp"

namespace foramen::synth {
namespace {

// Standard deviations of the laws. They were chosen together with those of the random fields
// (RoughDeformation).
constexpr double left_right_correlation = 0.6;
constexpr double growth_mm = 1.2, tilt_mm = 1.1;  // at the tip of a process
constexpr double slide_mm = 0.4, turn = 0.07, facet_growth = 0.07;
constexpr double rim_mm = 0.55;

template <std::size_t count>
using Scores = std::array<double, count>;

template <std::size_t count>
Scores<count> independent(Rng& rng) {
  Scores<count> scores;
  for (double& score : scores) score = rng.normal();
  return scores;
}

// Standard normal scores of the left and the right feature of a pair.
template <std::size_t count>
std::pair<Scores<count>, Scores<count>> left_and_right(Rng& rng) {
  const auto left = independent<count>(rng);
  auto right = independent<count>(rng);
  const double own = std::sqrt(1 - left_right_correlation * left_right_correlation);
  for (std::size_t k = 0; k < count; ++k) right[k] = left_right_correlation * left[k] + own * right[k];
  return {left, right};
}

// The matrix of x -> w cross x.
Mat3 turning(const Vec3& w) {
  Mat3 m;
  m << 0, -w.z(), w.y(), w.z(), 0, -w.x(), -w.y(), w.x(), 0;
  return m;
}

LocalMotion motion_of(const Process& process, const Scores<3>& scores) {
  const Vec3 axis = process.tip - process.base;
  const double length = axis.norm();
  // The window reaches along the process to its base, which the motion leaves at rest.
  const Vec3 deviations(0.6 * length, process.width_mm, process.width_mm);
  const Mat3 axes = frame(axis, std::abs(axis.z()) < 0.5 * length ? Vec3::UnitZ() : Vec3::UnitY());
  const Vec3 turn_axis = tilt_mm / length * (scores[1] * axes.col(1) + scores[2] * axes.col(2));
  return {
      .centre = process.tip,
      .precision = window_precision(axes, deviations),
      .pivot = process.base,
      .linear = growth_mm / length * scores[0] * axes.col(0) * axes.col(0).transpose() + turning(turn_axis)};
}

LocalMotion motion_of(const Facet& facet, const Scores<5>& scores) {
  const Mat3 axes = frame(facet.along, facet.normal);  // along, normal, across
  const Vec3 along = axes.col(0), across = axes.col(2);
  const Mat3 in_plane = along * along.transpose() + across * across.transpose();
  return {.centre = facet.centre,
          .precision = window_precision(axes, Vec3(6, 3, 5)),
          .pivot = facet.centre,
          .shift = slide_mm * (scores[0] * along + scores[1] * across),
          .linear =
              turning(turn * (scores[2] * along + scores[3] * across)) + facet_growth * scores[4] * in_plane};
}

// A random function of the angle around the body with unit variance. Even cosines and odd sines are
// symmetric left to right and the others are antisymmetric, so their variances set the correlation of left
// and right.
class RimLaw {
 public:
  explicit RimLaw(Rng& rng) {
    for (int order = 1; order <= orders; ++order) {
      const bool even = order % 2 == 0;
      const double common = std::sqrt(1 + left_right_correlation),
                   own = std::sqrt(1 - left_right_correlation);
      cosine_[order - 1] = (even ? common : own) * rng.normal();
      sine_[order - 1] = (even ? own : common) * rng.normal();
    }
  }
  double operator()(double angle) const {
    double sum = 0;
    for (int order = 1; order <= orders; ++order)
      sum += cosine_[order - 1] * std::cos(order * angle) + sine_[order - 1] * std::sin(order * angle);
    return sum / std::sqrt(static_cast<double>(orders));
  }

 private:
  static constexpr int orders = 6;
  std::array<double, orders> cosine_{}, sine_{};
};

void add_rim(LocalMotions& motions, int side, Rng& rng) {
  constexpr int points = 24;
  constexpr double window_mm = 4.0;
  // Neighbouring windows overlap. Their sum along a straight rim is sqrt(2 pi) window / spacing.
  constexpr double length_mm = 120;
  const double overlap = std::sqrt(2 * std::numbers::pi) * window_mm * points / length_mm;
  const RimLaw outward(rng), upward(rng);
  for (const RimPoint& at : endplate_rim(side, points))
    motions.all.push_back(
        {.centre = at.position,
         .precision = Mat3::Identity() / (window_mm * window_mm),
         .shift = rim_mm / overlap * (outward(at.angle) * at.outward + 0.6 * upward(at.angle) * at.upward)});
}

LocalMotion spur(const Vec3& place, const Vec3& outward, Rng& rng) {
  const double width = rng.uniform(2.0, 3.2), height = rng.uniform(1.0, 3.0);
  return {.centre = place,
          .precision = Mat3::Identity() / (width * width),
          .shift = height * outward.normalized()};
}

LocalMotion spur_of_rim(Rng& rng) {
  constexpr int places = 90;
  const int side = rng.uniform() < 0.5 ? 1 : -1;
  const RimPoint at = endplate_rim(side, places)[static_cast<std::size_t>(rng.below(places))];
  return spur(at.position, at.outward + rng.uniform(-0.3, 0.5) * at.upward, rng);
}

LocalMotion spur_of_facet(Rng& rng) {
  constexpr double margin_mm = 7;
  const Facet facet = left_facets()[static_cast<std::size_t>(rng.below(2))];
  const bool right = rng.uniform() < 0.5;
  // On the free half of the margin, towards the tip.
  const double angle = rng.uniform(-0.5, 0.5) * std::numbers::pi;
  const Vec3 outward = std::cos(angle) * facet.along + std::sin(angle) * facet.normal.cross(facet.along);
  const LocalMotion left = spur(facet.centre + margin_mm * outward, outward, rng);
  return right ? mirrored(left) : left;
}

}  // namespace

LocalMotions rough_motions(Rng& rng) {
  LocalMotions motions;
  motions.all.push_back(motion_of(spinous_process(), independent<3>(rng)));
  const auto add_pair = [&](const auto& feature, const auto& scores) {
    motions.all.push_back(motion_of(feature, scores.first));
    motions.all.push_back(mirrored(motion_of(feature, scores.second)));
  };
  for (const Process& process : left_processes()) add_pair(process, left_and_right<3>(rng));
  for (const Facet& facet : left_facets()) add_pair(facet, left_and_right<5>(rng));
  for (const int side : {1, -1}) add_rim(motions, side, rng);
  const int spurs = 2 + rng.below(6);
  for (int k = 0; k < spurs; ++k)
    motions.all.push_back(rng.uniform() < 0.7 ? spur_of_rim(rng) : spur_of_facet(rng));
  return motions;
}

}  // namespace foramen::synth
