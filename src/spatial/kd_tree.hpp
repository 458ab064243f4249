#pragma once
/// \file
/// Nearest points in any dimension by nanoflann, which is used here only. Ties are broken by index.

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include <nanoflann.hpp>

#include "spatial/point_index.hpp"

namespace foramen::detail {

/// Whether a precedes b in the list of the neighbours of a point.
inline bool nearer(const NearPoint& a, const NearPoint& b) {
  return a.squared_distance < b.squared_distance ||
         (a.squared_distance == b.squared_distance && a.index < b.index);
}

/// nanoflann skips points beyond the worst distance found so far times this factor. The factor is slightly
/// above 1, so that no point of equal distance is skipped when nanoflann rounds its sums differently.
inline constexpr double tie_slack = 1 + 1e-12;

/// A result set in the sense of nanoflann that keeps the `capacity` nearest points, nearest first.
class Neighbours {
 public:
  using DistanceType = double;
  explicit Neighbours(std::size_t capacity) : capacity_(capacity) { kept_.reserve(capacity + 1); }
  std::size_t size() const { return kept_.size(); }
  bool full() const { return kept_.size() == capacity_; }
  bool addPoint(double squared_distance, unsigned index) {
    const NearPoint candidate{static_cast<int>(index), squared_distance};
    if (full() && !nearer(candidate, kept_.back())) return true;
    if (full()) kept_.pop_back();
    kept_.insert(std::upper_bound(kept_.begin(), kept_.end(), candidate, nearer), candidate);
    return true;
  }
  double worstDist() const {
    if (!full()) return std::numeric_limits<double>::infinity();
    return kept_.back().squared_distance * tie_slack + std::numeric_limits<double>::min();
  }
  void sort() {}  // nanoflann calls it since version 1.6; the points are always sorted here
  std::vector<NearPoint> take() { return std::move(kept_); }

 private:
  std::size_t capacity_;
  std::vector<NearPoint> kept_;
};

/// The same for one neighbour, without dynamic memory.
class NearestOnly {
 public:
  using DistanceType = double;
  std::size_t size() const { return best_.index < 0 ? 0 : 1; }
  bool full() const { return size() == 1; }
  bool addPoint(double squared_distance, unsigned index) {
    const NearPoint candidate{static_cast<int>(index), squared_distance};
    if (!full() || nearer(candidate, best_)) best_ = candidate;
    return true;
  }
  double worstDist() const {
    if (!full()) return std::numeric_limits<double>::infinity();
    return best_.squared_distance * tie_slack + std::numeric_limits<double>::min();
  }
  void sort() {}  // as above
  const NearPoint& best() const { return best_; }

 private:
  NearPoint best_;
};

template <int Dimension>
class KdTree {
 public:
  using Point = std::array<double, static_cast<std::size_t>(Dimension)>;

  explicit KdTree(std::vector<Point> points) : cloud_{std::move(points)}, tree_(Dimension, cloud_) {}
  KdTree(const KdTree&) = delete;  // the tree points into the cloud
  KdTree& operator=(const KdTree&) = delete;

  NearPoint nearest(const Point& query) const {
    NearestOnly result;
    tree_.findNeighbors(result, query.data(), {});
    return result.best();
  }
  std::vector<NearPoint> nearest(const Point& query, int count) const {
    const std::size_t available = cloud_.points.size();
    Neighbours result(std::min<std::size_t>(available, std::max(count, 0)));
    if (count > 0) tree_.findNeighbors(result, query.data(), {});
    return result.take();
  }

 private:
  struct Cloud {
    std::vector<Point> points;
    std::size_t kdtree_get_point_count() const { return points.size(); }
    double kdtree_get_pt(std::size_t i, std::size_t k) const { return points[i][k]; }
    template <class Box>
    bool kdtree_get_bbox(Box&) const {
      return false;
    }
  };
  using Metric = nanoflann::L2_Simple_Adaptor<double, Cloud>;
  Cloud cloud_;
  nanoflann::KDTreeSingleIndexAdaptor<Metric, Cloud, Dimension> tree_;
};

}  // namespace foramen::detail
