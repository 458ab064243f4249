#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "spatial/triangle_closest.hpp"
#include "spatial/triangle_tree_detail.hpp"

namespace foramen {
namespace {

constexpr int bin_count = 16;
// From this depth on ranges are halved. This bounds the depth of the tree, and with it the stack of a query,
// for every input.
constexpr int halving_depth = 32;

struct Box {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity());
  Vec3 high = Vec3::Constant(-std::numeric_limits<double>::infinity());
  void add(const Vec3& p) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  void add(const Box& other) {
    low = low.cwiseMin(other.low);
    high = high.cwiseMax(other.high);
  }
  double half_area() const {
    const Vec3 s = (high - low).cwiseMax(0.0);
    return s[0] * s[1] + s[1] * s[2] + s[2] * s[0];
  }
};

struct Range {
  int first, count, depth;
};

Box box_of(const std::array<Vec3, 3>& t) {
  Box box;
  for (const Vec3& p : t) box.add(p);
  return box;
}

float rounded_down(double x) {
  return std::nextafter(static_cast<float>(x), -std::numeric_limits<float>::infinity());
}
float rounded_up(double x) {
  return std::nextafter(static_cast<float>(x), std::numeric_limits<float>::infinity());
}

}  // namespace

// Builds the tree by binary splits with the binned surface area heuristic (Wald 2007) and combines them to
// nodes of four children.
struct TriangleTree::Builder {
  TriangleTree& tree;
  std::vector<Box> boxes;
  std::vector<Vec3> centres;

  explicit Builder(TriangleTree& target) : tree(target) {
    const int faces = tree.mesh_.face_count();
    boxes.reserve(faces);
    centres.reserve(faces);
    tree.order_.reserve(faces);
    for (FaceId f : tree.mesh_.faces()) {
      boxes.push_back(box_of(tree.mesh_.triangle(f)));
      centres.push_back(0.5 * (boxes.back().low + boxes.back().high));
      tree.order_.push_back(f.index);
    }
    if (faces > 0) build({0, faces, 0});
  }

  int* at(int position) { return tree.order_.data() + position; }
  const Vec3& centre(int position) { return centres[*at(position)]; }
  const Box& box(int position) { return boxes[*at(position)]; }

  int build(const Range& range) {
    const int index = static_cast<int>(tree.nodes_.size());
    tree.nodes_.emplace_back();
    std::vector<Range> children{range};
    while (children.size() < 4) {
      const auto largest = std::max_element(children.begin(), children.end(),
                                            [](const Range& a, const Range& b) { return a.count < b.count; });
      if (largest->count <= detail::leaf_size) break;
      const Range whole = *largest;
      const int mid = split(whole);
      *largest = {whole.first, mid - whole.first, whole.depth + 1};
      children.insert(largest + 1, {mid, whole.first + whole.count - mid, whole.depth + 1});
    }
    std::array<int, 4> child;
    child.fill(detail::no_child);
    for (std::size_t k = 0; k < children.size(); ++k)
      child[k] = children[k].count <= detail::leaf_size
                     ? detail::encode_leaf(children[k].first, children[k].count)
                     : build(children[k]);
    tree.nodes_[index].child = child;
    return index;
  }

  // Reorders the range and returns where its second part begins.
  int split(const Range& range) {
    Box spread;
    for (int i = range.first; i < range.first + range.count; ++i) spread.add(centre(i));
    int axis = 0;
    const double width = (spread.high - spread.low).maxCoeff(&axis);
    if (!(width > 0) || range.depth >= halving_depth || range.count <= 2 * detail::leaf_size)
      return halve(range, axis);
    const double scale = bin_count / width;
    const auto bin_of = [&](int face) {
      const double offset = centres[face][axis] - spread.low[axis];
      return std::min(bin_count - 1, static_cast<int>(offset * scale));
    };
    const int cut = best_cut(range, bin_of);
    int* mid = std::partition(at(range.first), at(range.first) + range.count,
                              [&](int face) { return bin_of(face) < cut; });
    const int position = static_cast<int>(mid - tree.order_.data());
    if (position == range.first || position == range.first + range.count) return halve(range, axis);
    return position;
  }

  // The bin before which to split: the sum over both sides of number of triangles times box area is smallest.
  template <class BinOf>
  int best_cut(const Range& range, const BinOf& bin_of) {
    std::array<Box, bin_count> bins;
    std::array<int, bin_count> counts{};
    for (int i = range.first; i < range.first + range.count; ++i) {
      const std::size_t b = bin_of(*at(i));
      bins[b].add(box(i));
      ++counts[b];
    }
    // The first and the last bin contain the outermost centres, so neither side of a split is empty.
    std::array<double, bin_count> cost{};
    Box side;
    int in_side = 0;
    for (std::size_t b = 0; b + 1 < bin_count; ++b) {
      side.add(bins[b]);
      in_side += counts[b];
      cost[b + 1] = in_side * side.half_area();
    }
    side = Box();
    in_side = 0;
    std::size_t best = bin_count - 1;
    for (std::size_t b = bin_count - 1; b > 0; --b) {
      side.add(bins[b]);
      in_side += counts[b];
      cost[b] += in_side * side.half_area();
      if (cost[b] < cost[best]) best = b;
    }
    return static_cast<int>(best);
  }

  int halve(const Range& range, int axis) {
    const int half = range.count / 2;
    std::nth_element(at(range.first), at(range.first + half), at(range.first) + range.count,
                     [&](int a, int b) {
                       const double x = centres[a][axis];
                       const double y = centres[b][axis];
                       return x < y || (x == y && a < b);
                     });
    return range.first + half;
  }
};

TriangleTree::TriangleTree(const Mesh& mesh, TreeNormals normals) : mesh_(mesh), kept_normals_(normals) {
  Builder builder(*this);
  nodes_.shrink_to_fit();
  refresh();
}

void TriangleTree::refit(const Mesh& mesh) {
  if (mesh.triangles() != mesh_.triangles())
    throw InvalidInput("TriangleTree::refit: the mesh has other triangles (" +
                       std::to_string(mesh.face_count()) + " against " + std::to_string(mesh_.face_count()) +
                       "); build a new tree for it");
  mesh_ = mesh;
  refresh();
}

// Computes everything that depends on vertex positions: boxes, normals and slivers.
void TriangleTree::refresh() {
  const std::size_t count = order_.size();
  const bool with_normals = kept_normals_ == TreeNormals::kept;
  corners_.resize(count);
  normals_.resize(with_normals ? count : 0);
  normal_nodes_.resize(with_normals ? nodes_.size() : 0);
  sliver_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    corners_[i] = mesh_.triangles()[order_[i]];
    const auto t = triangle(i);
    if (with_normals) normals_[i] = unit_normal(t);
    sliver_[i] = detail::is_sliver(t);
  }
  if (count == 0) return;
  const BoundingBox whole = bounding_box(mesh_.positions());
  origin_ = 0.5 * (whole.low + whole.high);
  // An upper bound of the rounding error of the subtraction of the origin.
  const double rounding = 4 * std::numeric_limits<double>::epsilon() *
                          std::max(whole.low.cwiseAbs().maxCoeff(), whole.high.cwiseAbs().maxCoeff());

  std::vector<std::pair<Box, Box>> below(nodes_.size());  // boxes of points and of normals
  for (std::size_t n = nodes_.size(); n-- > 0;) {
    Node& node = nodes_[n];
    for (std::size_t k = 0; k < 4; ++k) {
      Box points, normals;
      const int child = node.child[k];
      if (child >= 0) {
        std::tie(points, normals) = below[child];
      } else {
        for (int i = detail::leaf_first(child); i < detail::leaf_first(child) + detail::leaf_count(child);
             ++i) {
          points.add(box_of(triangle(static_cast<std::size_t>(i))));
          if (with_normals) normals.add(normals_[i]);
        }
      }
      below[n].first.add(points);
      below[n].second.add(normals);
      for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = static_cast<Eigen::Index>(i);
        node.low[i][k] = rounded_down(points.low[axis] - origin_[axis] - rounding);
        node.high[i][k] = rounded_up(points.high[axis] - origin_[axis] + rounding);
        if (!with_normals) continue;
        normal_nodes_[n].low[i][k] = rounded_down(normals.low[axis]);
        normal_nodes_[n].high[i][k] = rounded_up(normals.high[axis]);
      }
    }
  }
}

}  // namespace foramen
