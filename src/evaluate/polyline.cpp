#include "evaluate/polyline.hpp"

#include <algorithm>
#include <limits>

#include "foramen/core/error.hpp"

namespace foramen::detail {
namespace {

double distance_to_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 along = b - a;
  const double squared = along.squaredNorm();
  const double t = squared > 0 ? std::clamp((p - a).dot(along) / squared, 0.0, 1.0) : 0.0;
  return (a + t * along - p).norm();
}

double one_sided(const Polyline& from, const Polyline& to, int samples) {
  double sum = 0;
  for (const Vec3& p : from.resampled(samples)) sum += to.distance(p);
  return sum / samples;
}

}  // namespace

Polyline::Polyline(std::span<const Vec3> points, bool closed)
    : points_(points.begin(), points.end()), closed_(closed) {
  FORAMEN_ASSERT(!points_.empty());
  if (closed_) points_.push_back(points_.front());
  arc_.push_back(0);
  for (std::size_t i = 1; i < points_.size(); ++i)
    arc_.push_back(arc_.back() + (points_[i] - points_[i - 1]).norm());
}

Vec3 Polyline::at(double share) const {
  const double wanted = share * length();
  const auto next = std::upper_bound(arc_.begin(), arc_.end(), wanted);
  if (next == arc_.end()) return points_.back();
  const auto i = static_cast<std::size_t>(next - arc_.begin());  // at least 1, because arc_ begins with 0
  const double t = (wanted - arc_[i - 1]) / (arc_[i] - arc_[i - 1]);
  return (1 - t) * points_[i - 1] + t * points_[i];
}

std::vector<Vec3> Polyline::resampled(int count) const {
  std::vector<Vec3> samples;
  const double steps = closed_ ? count : count - 1;
  for (int k = 0; k < count; ++k) samples.push_back(at(k / steps));
  return samples;
}

Vec3 Polyline::centroid() const {
  if (!(length() > 0)) return points_.front();
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i < points_.size(); ++i)
    sum += (arc_[i] - arc_[i - 1]) * (points_[i - 1] + points_[i]) / 2;
  return sum / length();
}

double Polyline::distance(const Vec3& p) const {
  double smallest = (points_.front() - p).norm();
  for (std::size_t i = 1; i < points_.size(); ++i)
    smallest = std::min(smallest, distance_to_segment(p, points_[i - 1], points_[i]));
  return smallest;
}

double mean_distance(const Polyline& a, const Polyline& b, int samples) {
  return (one_sided(a, b, samples) + one_sided(b, a, samples)) / 2;
}

}  // namespace foramen::detail
