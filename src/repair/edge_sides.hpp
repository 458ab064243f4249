#pragma once
// The edges of a triangle soup, each with the triangle sides that lie on it.

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

#include "foramen/core/mesh.hpp"

namespace foramen::repair_detail {

/// Side k of triangle f runs from its corner k to the next; halfedge 3f+k.
struct Side {
  int low, high;  ///< points, low < high
  int halfedge;
  bool forward;  ///< runs from low to high
};

class EdgeSides {
 public:
  /// \pre no triangle has a corner twice
  explicit EdgeSides(const std::vector<std::array<int, 3>>& triangles);
  std::size_t edge_count() const { return first_.size() - 1; }
  std::span<const Side> sides(std::size_t edge) const {
    return std::span(sides_).subspan(first_[edge], first_[edge + 1] - first_[edge]);
  }

 private:
  std::vector<Side> sides_;
  std::vector<std::size_t> first_;  // first side of each edge, and the end
};

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }
  std::size_t root(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Merges the sets of a and b; the smaller root becomes the root of both.
  void join(std::size_t a, std::size_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace foramen::repair_detail
