#include "foramen/spatial/triangle_tree.hpp"

#include <algorithm>
#include <cmath>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "spatial/triangle_closest.hpp"
#include "spatial/triangle_tree_detail.hpp"

namespace foramen {
namespace {

using Floats = Eigen::Array4f;

// Squared box distances are sums of three squares in single precision with at most 5 roundings, a relative
// error of 3e-7. Boxes beyond the bound by less than this factor are still searched.
constexpr double box_slack = 1 + 2e-6;
// Relative shift by which rounded floats are moved outward.
constexpr float float_slack = 2 * std::numeric_limits<float>::epsilon();
constexpr float cosine_slack = 1e-5f;

template <class Row>
Floats load(const Row& row) {
  return Eigen::Map<const Floats, Eigen::Aligned16>(row.data());
}

float as_limit(double squared) {
  const double limit = squared * box_slack;
  return limit < static_cast<double>(std::numeric_limits<float>::max())
             ? static_cast<float>(limit)
             : std::numeric_limits<float>::infinity();
}

detail::TrianglePoint closest_on(const std::array<Vec3, 3>& t, bool sliver, const Vec3& query) {
  return sliver ? detail::closest_on_sliver(t, query) : detail::closest_on_regular(t, query);
}

ClosestPoint closest_point(const std::array<Vec3, 3>& t, const detail::TrianglePoint& p, FaceId face) {
  return {{face, Vec3(std::max(0.0, 1 - p.v - p.w), p.v, p.w)},
          detail::point_of(t, p.v, p.w),
          p.squared_distance};
}

// The best triangle so far: the nearest, and of equally near ones that of the smallest index.
struct Best {
  double squared_distance;
  int face = -1, slot = -1;
  detail::TrianglePoint where = {};
  void offer(const detail::TrianglePoint& p, int candidate, int candidate_slot) {
    const bool tie = p.squared_distance == squared_distance && candidate < face;
    if (!(p.squared_distance < squared_distance) && !tie) return;
    squared_distance = p.squared_distance;
    face = candidate;
    slot = candidate_slot;
    where = p;
  }
};

}  // namespace

ClosestPoint closest_on_triangle(const std::array<Vec3, 3>& triangle, const Vec3& query) {
  return closest_point(triangle, closest_on(triangle, detail::is_sliver(triangle), query), FaceId());
}

// A point or a box in the coordinates of the tree, rounded outward and repeated in four SIMD lanes.
struct TriangleTree::Query {
  std::array<Floats, 3> up, down;
  Query(const Vec3& point, const Vec3& origin) : Query(BoundingBox{point, point}, origin) {}
  Query(const BoundingBox& box, const Vec3& origin) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      const auto low = static_cast<float>(box.low[axis] - origin[axis]);
      const auto high = static_cast<float>(box.high[axis] - origin[axis]);
      up[i] = Floats::Constant(high + std::abs(high) * float_slack);
      down[i] = Floats::Constant(low - std::abs(low) * float_slack);
    }
  }
  /// The box of one child.
  Query(const Node& node, std::size_t child) {
    for (std::size_t i = 0; i < 3; ++i) {
      up[i] = Floats::Constant(node.high[i][child]);
      down[i] = Floats::Constant(node.low[i][child]);
    }
  }
  /// Lower bounds of the squared distances to the four boxes.
  Floats squared_distances(const Node& node) const {
    Floats sum = Floats::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const Floats d = (load(node.low[i]) - up[i]).max(down[i] - load(node.high[i])).max(0.0f);
      sum += d * d;
    }
    return sum;
  }
};

// Visits the boxes in order of distance. `prune(node, distances)` excludes children by setting their
// distances to NaN. `visit(slot)` is called for each triangle; it may lower `bound` (a squared distance) and
// returns true to stop the search.
template <class Prune, class Visit>
void TriangleTree::traverse(const Query& query, const double& bound, const Prune& prune,
                            const Visit& visit) const {
  struct Entry {
    float squared_distance;
    int child;
  };
  if (nodes_.empty()) return;
  std::array<Entry, detail::stack_size> stack;
  std::size_t top = 0;
  stack[top++] = {0.0f, 0};
  float limit = as_limit(bound);
  while (top > 0) {
    const Entry entry = stack[--top];
    if (!(entry.squared_distance <= limit)) continue;
    if (entry.child < 0) {
      const int first = detail::leaf_first(entry.child), end = first + detail::leaf_count(entry.child);
      for (int slot = first; slot < end; ++slot)
        if (visit(static_cast<std::size_t>(slot))) return;
      limit = as_limit(bound);
      continue;
    }
    const std::size_t index = entry.child;
    const Node& node = nodes_[index];
    Floats distances = query.squared_distances(node);
    prune(index, distances);
    const std::size_t base = top;
    for (std::size_t k = 0; k < 4; ++k) {
      const float d = distances[static_cast<Eigen::Index>(k)];
      if (!(d <= limit)) continue;
      std::size_t place = top++;
      for (; place > base && stack[place - 1].squared_distance < d; --place) stack[place] = stack[place - 1];
      stack[place] = {d, node.child[k]};
    }
  }
}

ClosestPoint TriangleTree::closest(const Vec3& query, double within) const {
  Best best{within > 0 ? within * within : 0.0};
  traverse(
      Query(query, origin_), best.squared_distance, [](std::size_t, Floats&) {},
      [&](std::size_t slot) {
        best.offer(closest_on(triangle(slot), sliver_[slot], query), order_[slot], static_cast<int>(slot));
        return false;
      });
  if (best.face < 0) return {};
  return closest_point(triangle(static_cast<std::size_t>(best.slot)), best.where, FaceId(best.face));
}

std::optional<ClosestPoint> TriangleTree::closest_compatible(const Vec3& query, const Vec3& normal,
                                                             double min_cosine, double within) const {
  FORAMEN_ASSERT(kept_normals_ == TreeNormals::kept);
  Best best{within > 0 ? within * within : 0.0};
  const Eigen::Array3f n = normal.cast<float>().array();
  const auto least = static_cast<float>(min_cosine) - cosine_slack * std::max(1.0f, n.abs().sum());
  const auto incompatible_to_nan = [&](std::size_t index, Floats& distances) {
    const NormalNode& node = normal_nodes_[index];
    Floats cosine = Floats::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const float x = n[static_cast<Eigen::Index>(i)];
      cosine += (load(node.low[i]) * x).max(load(node.high[i]) * x);
    }
    distances = (cosine > least).select(distances, Floats::Constant(std::numeric_limits<float>::quiet_NaN()));
  };
  traverse(Query(query, origin_), best.squared_distance, incompatible_to_nan, [&](std::size_t slot) {
    const Vec3& m = normals_[slot];
    if (!(m.dot(normal) > min_cosine) || m.isZero(0)) return false;
    best.offer(closest_on(triangle(slot), sliver_[slot], query), order_[slot], static_cast<int>(slot));
    return false;
  });
  if (best.face < 0) return std::nullopt;
  return closest_point(triangle(static_cast<std::size_t>(best.slot)), best.where, FaceId(best.face));
}

bool TriangleTree::any_within(const Vec3& query, double radius) const {
  if (!(radius >= 0)) return false;
  const double bound = radius * radius;
  bool found = false;
  traverse(
      Query(query, origin_), bound, [](std::size_t, Floats&) {},
      [&](std::size_t slot) {
        found = closest_on(triangle(slot), sliver_[slot], query).squared_distance <= bound;
        return found;
      });
  return found;
}

std::vector<FaceId> TriangleTree::faces_within(const Vec3& query, double radius) const {
  std::vector<FaceId> faces;
  if (!(radius >= 0)) return faces;
  const double bound = radius * radius;
  traverse(
      Query(query, origin_), bound, [](std::size_t, Floats&) {},
      [&](std::size_t slot) {
        if (closest_on(triangle(slot), sliver_[slot], query).squared_distance <= bound)
          faces.emplace_back(order_[slot]);
        return false;
      });
  std::sort(faces.begin(), faces.end());
  return faces;
}

// Finds overlapping boxes by descending into both nodes of a pair.
struct TriangleTree::Overlaps {
  const TriangleTree& tree;
  const std::function<void(FaceId, FaceId)>& visit;
  std::vector<BoundingBox> boxes;  // of the triangles, in the order of the leaves

  const Node& node(int child) const { return tree.nodes_[child]; }
  static bool meet(const BoundingBox& a, const BoundingBox& b) {
    return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
  }

  void compare(std::size_t a, std::size_t b) const {
    if (!meet(boxes[a], boxes[b])) return;
    const auto [first, second] = std::minmax(tree.order_[a], tree.order_[b]);
    visit(FaceId(first), FaceId(second));
  }

  void within(int child) const {
    if (child < 0) {
      const std::size_t first = detail::leaf_first(child);
      const auto end = first + static_cast<std::size_t>(detail::leaf_count(child));
      for (std::size_t a = first; a < end; ++a)
        for (std::size_t b = a + 1; b < end; ++b) compare(a, b);
      return;
    }
    const Node& n = node(child);
    for (std::size_t k = 0; k < 4; ++k) {
      within(n.child[k]);
      const Floats distances = Query(n, k).squared_distances(n);
      for (std::size_t l = k + 1; l < 4; ++l)
        if (distances[static_cast<Eigen::Index>(l)] <= 0) between(n.child[k], n.child[l]);
    }
  }

  void between(int a, int b) const {
    if (a < 0 && b < 0) return between_leaves(a, b);
    if (a < 0 || b < 0)
      return below(std::max(a, b), Query(leaf_box(std::min(a, b)), tree.origin_), std::min(a, b));
    for (std::size_t k = 0; k < 4; ++k) below(b, Query(node(a), k), node(a).child[k]);
  }

  // Finds the overlaps of the child `other`, whose box is the query, with the children of a node.
  void below(int inner, const Query& query, int other) const {
    const Node& n = node(inner);
    const Floats distances = query.squared_distances(n);
    for (std::size_t l = 0; l < 4; ++l)
      if (distances[static_cast<Eigen::Index>(l)] <= 0) between(other, n.child[l]);
  }

  void between_leaves(int a, int b) const {
    for (int i = 0; i < detail::leaf_count(a); ++i)
      for (int j = 0; j < detail::leaf_count(b); ++j)
        compare(static_cast<std::size_t>(detail::leaf_first(a) + i),
                static_cast<std::size_t>(detail::leaf_first(b) + j));
  }

  BoundingBox leaf_box(int leaf) const {
    const std::size_t first = detail::leaf_first(leaf);
    BoundingBox box = boxes[first];
    for (std::size_t i = first + 1; i < first + static_cast<std::size_t>(detail::leaf_count(leaf)); ++i) {
      box.low = box.low.cwiseMin(boxes[i].low);
      box.high = box.high.cwiseMax(boxes[i].high);
    }
    return box;
  }
};

void TriangleTree::for_each_overlap(const std::function<void(FaceId, FaceId)>& visit) const {
  if (nodes_.empty()) return;
  Overlaps overlaps{*this, visit, {}};
  overlaps.boxes.reserve(corners_.size());
  for (std::size_t slot = 0; slot < corners_.size(); ++slot)
    overlaps.boxes.push_back(bounding_box(triangle(slot)));
  overlaps.within(0);
}

}  // namespace foramen
