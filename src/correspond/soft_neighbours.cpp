#include "correspond/soft_neighbours.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "foramen/core/error.hpp"
#include "match/oriented_points.hpp"
#include "spatial/point_index.hpp"

namespace foramen {
namespace {

std::vector<std::vector<NearPoint>> neighbours(const Mesh& shape, const Mesh& reference,
                                               NeighbourSearch search, int count) {
  std::vector<std::vector<NearPoint>> found;
  found.reserve(shape.vertex_count());
  if (search == NeighbourSearch::points) {
    const PointIndex index(reference.positions());
    for (VertexId v : shape.vertices()) found.push_back(index.nearest(shape.position(v), count));
  } else {
    const IndexedPoints index(oriented_vertices(reference), vertebra_normal_weight_mm);
    for (const OrientedPoint& p : oriented_vertices(shape)) found.push_back(index.nearest(p, count));
  }
  return found;
}

}  // namespace

SoftNeighbours::SoftNeighbours(const Mesh& aligned_shape, const Mesh& reference,
                               const TorusMap& reference_map, const SoftNeighboursOptions& options)
    : count_(std::min(options.count, reference.vertex_count())),
      squared_smoothing_(options.smoothing * options.smoothing),
      reducer_(reference_map.lattice) {
  FORAMEN_ASSERT(options.count > 0 && options.smoothing > 0);
  const auto found = neighbours(aligned_shape, reference, options.search, count_);
  targets_.reserve(found.size() * static_cast<std::size_t>(count_));
  weights_.reserve(targets_.capacity());
  for (VertexId v : aligned_shape.vertices()) {
    const auto& near = found[v.index];
    const Vec3& p = aligned_shape.position(v);
    const double closest = (reference.position(VertexId(near.front().index)) - p).norm();
    const double offset = options.weights == NeighbourWeights::relative ? closest : 0.0;
    double sum = 0;
    for (const NearPoint& n : near) {
      const double w =
          std::exp(offset - (reference.position(VertexId(n.index)) - p).norm());  // [becker2011 Eq. 4]
      targets_.push_back(reference_map.lattice * reference_map.turns[VertexId(n.index)]);
      weights_.push_back(w);
      sum += w;
    }
    if (options.weights == NeighbourWeights::relative)
      for (auto w = weights_.end() - count_; w != weights_.end(); ++w) *w /= sum;
  }
}

CorrespondenceObjective::Term SoftNeighbours::term(VertexId v, const Vec2& plane_position) const {
  Term sum;
  const auto first = static_cast<std::size_t>(v.index) * static_cast<std::size_t>(count_);
  for (std::size_t k = first; k < first + static_cast<std::size_t>(count_); ++k) {
    const Vec2 d = reducer_.shortest(plane_position - targets_[k]);
    const double r = std::sqrt(d.squaredNorm() + squared_smoothing_);
    const double w = weights_[k] / r;
    sum.value += weights_[k] * r;
    sum.gradient += w * d;
    sum.hessian += w * (Mat2::Identity() - d * d.transpose() / (r * r));
  }
  return sum;
}

}  // namespace foramen
