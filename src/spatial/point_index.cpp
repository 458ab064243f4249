#include "spatial/point_index.hpp"

#include <string>

#include "foramen/core/error.hpp"
#include "spatial/kd_tree.hpp"

namespace foramen {
namespace {

using Tree3 = detail::KdTree<3>;
using Tree6 = detail::KdTree<6>;

std::vector<Tree3::Point> arrays(std::span<const Vec3> points) {
  std::vector<Tree3::Point> out;
  out.reserve(points.size());
  for (const Vec3& p : points) out.push_back({p.x(), p.y(), p.z()});
  return out;
}

Tree6::Point oriented(const Vec3& p, const Vec3& n, double weight) {
  return {p.x(), p.y(), p.z(), weight * n.x(), weight * n.y(), weight * n.z()};
}

std::vector<Tree6::Point> oriented(std::span<const Vec3> points, std::span<const Vec3> normals,
                                   double weight) {
  if (points.size() != normals.size())
    throw InvalidInput("OrientedPointIndex: " + std::to_string(points.size()) + " points but " +
                       std::to_string(normals.size()) + " normals; give one normal per point");
  if (!(weight >= 0)) throw InvalidInput("OrientedPointIndex: the normal weight must be >= 0 mm");
  std::vector<Tree6::Point> out;
  out.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) out.push_back(oriented(points[i], normals[i], weight));
  return out;
}

}  // namespace

struct PointIndex::Impl {
  Tree3 tree;
};

PointIndex::PointIndex(std::span<const Vec3> points) : impl_(new Impl{Tree3(arrays(points))}) {}
PointIndex::~PointIndex() = default;
PointIndex::PointIndex(PointIndex&&) noexcept = default;
PointIndex& PointIndex::operator=(PointIndex&&) noexcept = default;

NearPoint PointIndex::nearest(const Vec3& query) const {
  return impl_->tree.nearest({query.x(), query.y(), query.z()});
}

std::vector<NearPoint> PointIndex::nearest(const Vec3& query, int count) const {
  return impl_->tree.nearest({query.x(), query.y(), query.z()}, count);
}

struct OrientedPointIndex::Impl {
  double weight;
  Tree6 tree;
};

OrientedPointIndex::OrientedPointIndex(std::span<const Vec3> points, std::span<const Vec3> normals,
                                       double normal_weight)
    : impl_(new Impl{normal_weight, Tree6(oriented(points, normals, normal_weight))}) {}
OrientedPointIndex::~OrientedPointIndex() = default;
OrientedPointIndex::OrientedPointIndex(OrientedPointIndex&&) noexcept = default;
OrientedPointIndex& OrientedPointIndex::operator=(OrientedPointIndex&&) noexcept = default;

NearPoint OrientedPointIndex::nearest(const Vec3& query, const Vec3& normal) const {
  return impl_->tree.nearest(oriented(query, normal, impl_->weight));
}

std::vector<NearPoint> OrientedPointIndex::nearest(const Vec3& query, const Vec3& normal, int count) const {
  return impl_->tree.nearest(oriented(query, normal, impl_->weight), count);
}

}  // namespace foramen
