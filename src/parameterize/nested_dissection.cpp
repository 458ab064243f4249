#include "parameterize/nested_dissection.hpp"

#include <algorithm>
#include <cstdint>
#include <tuple>
#include <utility>

namespace foramen {
namespace {

/// Parts of up to this many vertices are not split, because one dense block of twice this size is faster than
/// smaller blocks.
constexpr std::size_t leaf_vertices = 16;

// Adjacency lists of all vertices in one array.
struct Graph {
  std::vector<int> begin, neighbour;

  explicit Graph(const Mesh& mesh) {
    begin.assign(static_cast<std::size_t>(mesh.vertex_count()) + 1, 0);
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      ++begin[static_cast<std::size_t>(mesh.from(h).index) + 1];
      ++begin[static_cast<std::size_t>(mesh.to(h).index) + 1];
    }
    for (std::size_t v = 1; v < begin.size(); ++v) begin[v] += begin[v - 1];
    neighbour.resize(begin.back());
    std::vector<int> next(begin.begin(), begin.end() - 1);
    for (EdgeId e : mesh.edges()) {
      const HalfedgeId h = mesh.halfedge(e);
      const int a = mesh.from(h).index, b = mesh.to(h).index;
      neighbour[next[a]++] = b;
      neighbour[next[b]++] = a;
    }
  }
};

class Dissection {
 public:
  Dissection(const Mesh& mesh, const Eigen::MatrixXd& coordinates)
      : graph_(mesh), coordinates_(coordinates), side_(mesh.vertex_count(), outside) {}

  DissectionTree run() {
    std::vector<int> all(side_.size());
    for (std::size_t v = 0; v < all.size(); ++v) all[v] = static_cast<int>(v);
    add(std::move(all));
    return std::move(tree_);
  }

 private:
  enum Side : std::uint8_t { outside, low, high };

  // Adds the part and all its sub-parts; returns the index of its node.
  int add(std::vector<int> part) {
    DissectionNode node;
    if (part.size() <= leaf_vertices) {
      std::sort(part.begin(), part.end());
      node.columns = std::move(part);
    } else {
      auto [separator, first, second] = split(part);
      part = {};
      if (!first.empty()) node.children[0] = add(std::move(first));
      if (!second.empty()) node.children[1] = add(std::move(second));
      node.columns = std::move(separator);
    }
    tree_.push_back(std::move(node));
    return static_cast<int>(tree_.size()) - 1;
  }

  struct Split {
    std::vector<int> separator, first, second;
  };

  Split split(std::vector<int>& part) {
    Split best;
    for (int axis = 0; axis < coordinates_.cols(); ++axis) {
      const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
      std::nth_element(part.begin(), middle, part.end(), [&](int a, int b) {
        return std::make_pair(coordinates_(a, axis), a) < std::make_pair(coordinates_(b, axis), b);
      });
      for (auto it = part.begin(); it != part.end(); ++it) side_[*it] = it < middle ? low : high;
      for (const Side taken : {low, high}) {
        const std::size_t size =
            std::count_if(part.begin(), part.end(), [&](int v) { return is_border(v, taken); });
        if (best.separator.empty() || size < best.separator.size()) best = divided(part, taken);
      }
    }
    for (int v : part) side_[v] = outside;
    return best;
  }

  // Whether v is on this side and has a neighbour on the other.
  bool is_border(int v, Side taken) const {
    if (side_[v] != taken) return false;
    const auto other = taken == low ? high : low;
    for (int k = graph_.begin[v]; k < graph_.begin[static_cast<std::size_t>(v) + 1]; ++k)
      if (side_[graph_.neighbour[k]] == other) return true;
    return false;
  }

  Split divided(const std::vector<int>& part, Side taken) const {
    Split out;
    for (int v : part) {
      if (is_border(v, taken))
        out.separator.push_back(v);
      else
        (side_[v] == low ? out.first : out.second).push_back(v);
    }
    // Sorted by index, because the order that nth_element leaves is unspecified.
    std::sort(out.separator.begin(), out.separator.end());
    return out;
  }

  Graph graph_;
  const Eigen::MatrixXd& coordinates_;
  std::vector<Side> side_;
  DissectionTree tree_;
};

}  // namespace

DissectionTree dissect(const Mesh& mesh, const Eigen::MatrixXd& coordinates) {
  return Dissection(mesh, coordinates).run();
}

}  // namespace foramen
