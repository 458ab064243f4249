#pragma once
/// \file
/// An elimination order for sparse Cholesky factorisation on the vertex graph of a mesh, by recursive
/// geometric bisection.

#include <array>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A part of the graph that is eliminated as one dense block: a separator, or a part too small to be split.
struct DissectionNode {
  std::vector<int> columns;                ///< vertices, in the order of elimination
  std::array<int, 2> children = {-1, -1};  ///< the parts that it separates; both -1 for a leaf
};

/// Nodes in postorder: children come before their parent and the root is last.
using DissectionTree = std::vector<DissectionNode>;

/// Splits the vertices at the median of the coordinate with the smallest separator and continues with both
/// halves, down to leaves. Separators are computed from the graph, so on a torus, where two cuts are needed
/// to separate the halves, a separator contains both.
/// \param coordinates  one row per vertex: numbers that are close for neighbouring vertices, e.g. positions
/// in space and on the torus
DissectionTree dissect(const Mesh& mesh, const Eigen::MatrixXd& coordinates);

}  // namespace foramen
