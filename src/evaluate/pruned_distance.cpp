#include "evaluate/pruned_distance.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace foramen::detail {
namespace {

// Relative margin for the rounding of centres and radii in bounds.
constexpr double bound_margin = 1e-12;

/// The largest distance from points of one surface to another, computed cluster by cluster.
class FarthestPoint {
 public:
  FarthestPoint(const MeasuredSurface& from, const PackedTriangles& to, double give_up,
                const KnownDistances& known)
      : from_(from), to_(to), give_up_(give_up), known_(known) {}

  /// Raises `largest` to the largest distance of the points of one cluster; true if that is larger.
  bool raise(int index, double& largest) const {
    const PointCluster& cluster = from_.clusters()[index];
    const double enough = largest * (1 - bound_margin) - cluster.radius;
    if (known_.surely_within(cluster.centre, enough) || to_.any_within(cluster.centre, enough)) return false;
    const double from_centre = std::sqrt(to_.squared_distance(cluster.centre)),
                 surely = largest * (1 - bound_margin);
    bool raised = false;
    for (const Vec3& p : from_.points(cluster)) {
      if (from_centre + (p - cluster.centre).norm() <= surely || to_.any_within(p, largest)) continue;
      largest = std::max(largest, std::sqrt(to_.squared_distance(p)));
      raised = true;
      if (largest > give_up_) break;
    }
    return raised;
  }

  /// Raises `largest` by all clusters except `start`, which was tested before. `start` becomes the cluster
  /// that raised it last.
  double raise_all(int& start, double largest) const {
    const int first = start;
    for (int c = 0; c < static_cast<int>(from_.clusters().size()) && !(largest > give_up_); ++c)
      if (c != first && raise(c, largest)) start = c;
    return largest;
  }

 private:
  const MeasuredSurface& from_;
  const PackedTriangles& to_;
  double give_up_;
  KnownDistances known_;
};

}  // namespace

double hausdorff_distance(const MeasuredSurface& a, const MeasuredSurface& b, double give_up,
                          FarthestClusters& start, double at_least, const KnownDistances& to_b) {
  const FarthestPoint from_a(a, b.tree(), give_up, to_b), from_b(b, a.tree(), give_up, {});
  double largest = at_least;
  from_a.raise(start.of_a, largest);
  if (largest > give_up) return largest;
  from_b.raise(start.of_b, largest);
  if (largest > give_up) return largest;
  largest = from_a.raise_all(start.of_a, largest);
  if (largest > give_up) return largest;
  return from_b.raise_all(start.of_b, largest);
}

std::vector<double> sample_distances(const MeasuredSurface& from, const MeasuredSurface& to) {
  std::vector<double> distances;
  distances.reserve(from.samples().size());
  for (const Vec3& p : from.samples()) distances.push_back(std::sqrt(to.tree().squared_distance(p)));
  return distances;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace foramen::detail
