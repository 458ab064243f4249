#pragma once
/// \file
/// The encoding of child references in the nodes of a TriangleTree.

#include "foramen/spatial/triangle_tree.hpp"

namespace foramen::detail {

/// Largest number of triangles in a leaf.
inline constexpr int leaf_size = 2;
inline constexpr int leaf_count_bits = 3;
/// Size of the stack of a query: 32 levels of binary splits by area and 31 halvings of at most 2^31 faces,
/// where each level leaves at most three siblings on the stack.
inline constexpr int stack_size = 256;

/// A child is an inner node (>= 0) or the complement of first * 8 + count.
constexpr int encode_leaf(int first, int count) { return ~((first << leaf_count_bits) | count); }
constexpr int leaf_first(int child) { return ~child >> leaf_count_bits; }
constexpr int leaf_count(int child) { return ~child & ((1 << leaf_count_bits) - 1); }
/// Marks the absence of a child: a leaf without triangles.
inline constexpr int no_child = encode_leaf(0, 0);

}  // namespace foramen::detail
