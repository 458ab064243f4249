#include "evaluate/packed_triangles.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen::detail {
namespace {

using Floats = Eigen::Array4f;

constexpr float infinity = std::numeric_limits<float>::infinity();
// Larger than any squared distance, but with finite products with small numbers.
constexpr float very_far = 1e30f;
// Squared least ratio of the lower bound of distance_at_least() to the distance.
constexpr float least_part_squared = 0.7f;
constexpr int no_child = std::numeric_limits<int>::max();
// Error bound of a query in single precision, in rounding units of the largest coordinate. A query has about
// 40 operations, but their errors do not all have one sign.
constexpr float rounding_units = 32;
// The largest coordinate of a query from the centre of the mesh, relative to its diagonal: queries are near
// it.
constexpr double largest_coordinate = 0.52;
// Ratio of height to longest side below which distances to a triangle in single precision are useless.
constexpr double sliver_height = 0.02;
// Splits halve ranges, so the depth is at most 16 nodes, each of which leaves three siblings on the stack.
constexpr std::size_t stack_size = 128;
constexpr std::size_t candidate_count = 32;

template <class Row>
Floats load(const Row& row) {
  return Eigen::Map<const Floats, Eigen::Aligned16>(row.data());
}

float rounded_down(double x) { return std::nextafter(static_cast<float>(x), -infinity); }
float rounded_up(double x) { return std::nextafter(static_cast<float>(x), infinity); }

double reciprocal(double x) { return x > 0 ? 1 / x : 0; }

bool is_sliver(double det, double longest_squared) {
  return det <= sliver_height * sliver_height * longest_squared * longest_squared;
}

}  // namespace

/// Builds the hierarchy by splits at medians of centroids into multiples of four faces.
struct PackedTriangles::Builder {
  PackedTriangles& tree;
  std::vector<int> order;
  std::vector<Vec3> centroids;

  explicit Builder(PackedTriangles& target) : tree(target), order(target.mesh_.face_count()) {
    std::iota(order.begin(), order.end(), 0);
    for (FaceId f : tree.mesh_.faces()) {
      const auto t = tree.mesh_.triangle(f);
      centroids.push_back((t[0] + t[1] + t[2]) / 3);
    }
    build(0, tree.mesh_.face_count());
  }

  int build(int first, int last) {
    const int index = static_cast<int>(tree.nodes_.size());
    tree.nodes_.emplace_back();
    const int middle = split(first, last);
    const std::array<int, 5> cut{first, split(first, middle), middle, split(middle, last), last};
    std::array<int, 4> child{no_child, no_child, no_child, no_child};
    for (std::size_t k = 0; k < 4; ++k)
      if (cut[k] < cut[k + 1])
        child[k] = cut[k + 1] - cut[k] <= 4 ? packet(cut[k], cut[k + 1]) : build(cut[k], cut[k + 1]);
    tree.nodes_[index].child = child;
    return index;
  }

  int packet(int first, int last) {
    Packet packet{};
    for (int k = 0; k < 4; ++k) packet.face[k] = order[std::min(first + k, last - 1)];
    tree.packets_.push_back(packet);
    return ~static_cast<int>(tree.packets_.size() - 1);
  }

  /// The start of the second half of a range; `last` if the range is a single packet.
  int split(int first, int last) {
    if (last - first <= 4) return last;
    const auto centroid = [&](int face) -> const Vec3& { return centroids[face]; };
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (int i = first; i < last; ++i) {
      low = low.cwiseMin(centroid(order[i]));
      high = high.cwiseMax(centroid(order[i]));
    }
    Eigen::Index axis = 0;
    (high - low).maxCoeff(&axis);
    const int half = (last - first + 7) / 8 * 4;
    std::nth_element(
        order.begin() + first, order.begin() + first + half, order.begin() + last,
        [&](int a, int b) { return std::pair(centroid(a)[axis], a) < std::pair(centroid(b)[axis], b); });
    return first + half;
  }
};

PackedTriangles::PackedTriangles(const Mesh& mesh) : mesh_(mesh) {
  FORAMEN_ASSERT(mesh.face_count() > 0);
  Builder builder(*this);
  refresh();
}

void PackedTriangles::move_to(std::vector<Vec3> positions) {
  mesh_ = mesh_.with_positions(std::move(positions));
  refresh();
}

void PackedTriangles::fill(Packet& packet) const {
  for (std::size_t k = 0; k < 4; ++k) {
    const auto t = mesh_.triangle(FaceId(packet.face[k]));
    const Vec3 ab = t[1] - t[0], ac = t[2] - t[0];
    const double ab_ab = ab.squaredNorm(), ab_ac = ab.dot(ac), ac_ac = ac.squaredNorm();
    const double bc_bc = (t[2] - t[1]).squaredNorm(), det = ab.cross(ac).squaredNorm();
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      packet.a[i][k] = static_cast<float>(t[0][axis] - origin_[axis]);
      packet.ab[i][k] = static_cast<float>(ab[axis]);
      packet.ac[i][k] = static_cast<float>(ac[axis]);
    }
    packet.ab_ab[k] = static_cast<float>(ab_ab);
    packet.ab_ac[k] = static_cast<float>(ab_ac);
    packet.ac_ac[k] = static_cast<float>(ac_ac);
    packet.bc_bc[k] = static_cast<float>(bc_bc);
    const bool sliver = is_sliver(det, std::max({ab_ab, ac_ac, bc_bc}));
    packet.inverse_ab[k] = static_cast<float>(sliver ? 0 : reciprocal(ab_ab));
    packet.inverse_ac[k] = static_cast<float>(sliver ? 0 : reciprocal(ac_ac));
    packet.inverse_bc[k] = static_cast<float>(sliver ? 0 : reciprocal(bc_bc));
    packet.inverse_det[k] = static_cast<float>(sliver ? 0 : reciprocal(det));
    packet.doubt[k] = sliver ? infinity : rounding_;
  }
}

void PackedTriangles::refresh() {
  const BoundingBox whole = bounding_box(mesh_.positions());
  origin_ = 0.5 * (whole.low + whole.high);
  const double scale = largest_coordinate * whole.diagonal();
  rounding_ = rounding_units * std::numeric_limits<float>::epsilon() * static_cast<float>(scale);
  for (Packet& p : packets_) fill(p);

  std::vector<std::pair<Vec3, Vec3>> box(nodes_.size());
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    for (std::size_t k = 0; k < 4; ++k) {
      Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
      if (node.child[k] == no_child) {
        // no child: the box stays empty
      } else if (node.child[k] >= 0) {
        std::tie(low, high) = box[node.child[k]];
      } else {
        for (const int face : packets_[~node.child[k]].face)
          for (const Vec3& p : mesh_.triangle(FaceId(face))) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
          }
      }
      box[n].first = k == 0 ? low : Vec3(box[n].first.cwiseMin(low));
      box[n].second = k == 0 ? high : Vec3(box[n].second.cwiseMax(high));
      for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        node.low[i][k] = rounded_down(low[axis] - origin_[axis]);
        node.high[i][k] = rounded_up(high[axis] - origin_[axis]);
      }
    }
  }
}

// The query in the coordinates of the packets, repeated in four lanes.
struct PackedTriangles::Query {
  std::array<Floats, 3> point;
  Query(const Vec3& query, const Vec3& origin) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto axis = static_cast<Eigen::Index>(i);
      point[i] = Floats::Constant(static_cast<float>(query[axis] - origin[axis]));
    }
  }
  Floats to_boxes(const Node& node) const {
    Floats sum = Floats::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const Floats d = (load(node.low[i]) - point[i]).max(point[i] - load(node.high[i])).max(0.0f);
      sum += d * d;
    }
    return sum;
  }
  struct ToTriangles {
    Floats squared, doubt;
  };
  /// Squared distances and bounds of their errors. A distance is the minimum of those to the sides and, if
  /// the projection falls inside the triangle, that to the plane.
  ToTriangles to_triangles(const Packet& t) const {
    Floats p_p = Floats::Zero(), p_ab = Floats::Zero(), p_ac = Floats::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      const Floats p = point[i] - load(t.a[i]);
      p_p += p * p;
      p_ab += p * load(t.ab[i]);
      p_ac += p * load(t.ac[i]);
    }
    const Floats ab_ab = load(t.ab_ab), ab_ac = load(t.ab_ac), ac_ac = load(t.ac_ac), bc_bc = load(t.bc_bc);
    const Floats r = (p_ab * load(t.inverse_ab)).max(0.0f).min(1.0f);
    const Floats s = (p_ac * load(t.inverse_ac)).max(0.0f).min(1.0f);
    const Floats q_bc = p_ac - p_ab - ab_ac + ab_ab;
    const Floats u = (q_bc * load(t.inverse_bc)).max(0.0f).min(1.0f);
    const Floats to_ab = p_p + r * (r * ab_ab - 2.0f * p_ab);
    const Floats to_ac = p_p + s * (s * ac_ac - 2.0f * p_ac);
    const Floats to_bc = p_p - 2.0f * p_ab + ab_ab + u * (u * bc_bc - 2.0f * q_bc);
    const Floats v = (ac_ac * p_ab - ab_ac * p_ac) * load(t.inverse_det);
    const Floats w = (ab_ab * p_ac - ab_ac * p_ab) * load(t.inverse_det);
    const Floats to_plane = p_p - v * p_ab - w * p_ac;
    const Floats outside = (-v).max(-w).max(v + w - 1.0f);
    const Floats to_sides = to_ab.min(to_ac).min(to_bc);
    const Floats squared = (outside <= 0.0f).select(to_plane.min(to_sides), to_sides).max(0.0f);
    return {squared, load(t.doubt) * (1.0f + p_p + ab_ab + ac_ac)};
  }
};

namespace {

// For an exact search: ignores skipped boxes.
struct Nothing {
  void add(const Floats&, float) {}
  void add(float) {}
};

// For a lower bound: the smallest squared distance of the skipped boxes.
struct SmallestSkipped {
  Floats lanes = Floats::Constant(very_far);
  void add(const Floats& to_box, float bound) {
    lanes = lanes.min((to_box > bound).select(to_box, very_far));
  }
  void add(float to_box) { lanes[0] = std::min(lanes[0], to_box); }
};

}  // namespace

// Visits the nearest boxes first and skips boxes beyond `limit` (a squared distance). `visit(packet)` may
// lower the limit and returns true to stop.
template <class Visit, class Skipped>
void PackedTriangles::traverse(const Query& query, const float& limit, const Visit& visit,
                               Skipped& skipped) const {
  // Two arrays are faster than one array of pairs: a pair that is written in two parts and read as one stalls
  // the processor (store forwarding).
  std::array<float, stack_size> distance;
  std::array<int, stack_size> child;
  std::size_t top = 0;
  int current = 0;
  for (;;) {
    if (current >= 0) {
      const Node& node = nodes_[current];
      const Floats to_box = query.to_boxes(node);
      // A rounding error e of coordinates changes a squared distance d^2 by about 2 d e, and 2 d <= 1 + d^2.
      const float bound = limit + rounding_ * (1.0f + limit);
      skipped.add(to_box, bound);
      // All children within the limit are pushed and the nearest is followed. The loop has no branches,
      // because they could not be predicted.
      const std::size_t base = top;
      std::size_t nearest = base;
      float nearest_distance = very_far;
      for (std::size_t k = 0; k < 4; ++k) {
        const float d = to_box[static_cast<Eigen::Index>(k)];
        distance[top] = d;
        child[top] = node.child[k];
        const bool nearer = d < nearest_distance;
        nearest_distance = nearer ? d : nearest_distance;
        nearest = nearer ? top : nearest;
        top += d <= bound ? 1 : 0;
      }
      if (top > base) {
        current = child[nearest];
        --top;
        distance[nearest] = distance[top];
        child[nearest] = child[top];
        continue;
      }
    } else if (visit(packets_[~current])) {
      return;
    }
    const float bound = limit + rounding_ * (1.0f + limit);
    while (top > 0 && distance[top - 1] > bound) skipped.add(distance[--top]);
    if (top == 0) return;
    current = child[--top];
  }
}

double PackedTriangles::squared_distance(const Vec3& query) const {
  struct Candidate {
    float at_least;
    int face;
  };
  std::array<Candidate, candidate_count> candidates;
  std::size_t count = 0;
  double smallest = std::numeric_limits<double>::infinity();
  float limit = very_far;  // an upper bound of the smallest squared distance
  const auto settle = [&] {
    for (std::size_t c = 0; c < count; ++c)
      if (candidates[c].at_least <= limit)
        smallest =
            std::min(smallest,
                     closest_on_triangle(mesh_.triangle(FaceId(candidates[c].face)), query).squared_distance);
    limit = std::min(limit, rounded_up(smallest));
    count = 0;
  };
  const Query lanes(query, origin_);
  Nothing nothing;
  traverse(
      lanes, limit,
      [&](const Packet& packet) {
        const auto [squared, doubt] = lanes.to_triangles(packet);
        const Floats at_least = squared - doubt, at_most = squared + doubt;
        limit = std::min(limit, at_most.minCoeff());
        if (count + 4 > candidate_count) settle();
        for (std::size_t k = 0; k < 4; ++k) {
          candidates[count] = {at_least[static_cast<Eigen::Index>(k)], packet.face[k]};
          count += candidates[count].at_least <= limit ? 1 : 0;
        }
        return false;
      },
      nothing);
  settle();
  return smallest;
}

double PackedTriangles::distance_at_least(const Vec3& query) const {
  // Boxes that are only slightly nearer than the nearest triangle so far are skipped; they then determine the
  // lower bound.
  const Query lanes(query, origin_);
  float nearest_at_most = very_far, nearest_at_least = very_far, limit = very_far;
  SmallestSkipped skipped;
  traverse(
      lanes, limit,
      [&](const Packet& packet) {
        const auto [squared, doubt] = lanes.to_triangles(packet);
        nearest_at_least = std::min(nearest_at_least, (squared - doubt).minCoeff());
        nearest_at_most = std::min(nearest_at_most, (squared + doubt).minCoeff());
        limit = least_part_squared * nearest_at_most;
        return false;
      },
      skipped);
  const float boxes = skipped.lanes.minCoeff();
  const float at_least = std::min(nearest_at_least, boxes - rounding_ * (1.0f + boxes));
  return std::sqrt(static_cast<double>(std::max(0.0f, at_least)));
}

bool PackedTriangles::any_within(const Vec3& query, double radius) const {
  if (!(radius >= 0)) return false;
  const double squared_radius = radius * radius;
  const float limit = rounded_up(squared_radius), surely = rounded_down(squared_radius);
  bool found = false;
  const Query lanes(query, origin_);
  Nothing nothing;
  traverse(
      lanes, limit,
      [&](const Packet& packet) {
        const auto [squared, doubt] = lanes.to_triangles(packet);
        if ((squared + doubt).minCoeff() <= surely) return found = true;
        const Floats at_least = squared - doubt;
        for (std::size_t k = 0; k < 4 && !found; ++k)
          if (at_least[static_cast<Eigen::Index>(k)] <= limit)
            found = closest_on_triangle(mesh_.triangle(FaceId(packet.face[k])), query).squared_distance <=
                    squared_radius;
        return found;
      },
      nothing);
  return found;
}

}  // namespace foramen::detail
