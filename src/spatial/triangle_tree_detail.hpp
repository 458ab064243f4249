#pragma once
/// \file
/// How the nodes of a TriangleTree name their children.

#include "foramen/spatial/triangle_tree.hpp"

namespace foramen::detail {

/// Triangles in a leaf, at most.
inline constexpr int leaf_size = 2;
inline constexpr int leaf_count_bits = 3;
/// Entries on the stack of a query: 32 levels of binary splits by area, then halvings of at most 2^31 faces,
/// each leaving at most three siblings behind.
inline constexpr int stack_size = 256;

/// A child is an inner node (>= 0) or the complement of first * 8 + count.
constexpr int encode_leaf(int first, int count) { return ~((first << leaf_count_bits) | count); }
constexpr int leaf_first(int child) { return ~child >> leaf_count_bits; }
constexpr int leaf_count(int child) { return ~child & ((1 << leaf_count_bits) - 1); }
/// A leaf without triangles.
inline constexpr int no_child = encode_leaf(0, 0);

}  // namespace foramen::detail
