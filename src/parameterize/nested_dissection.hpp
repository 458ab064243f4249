#pragma once
/// \file
/// An order of elimination for sparse Cholesky on the vertex graph of a mesh: recursive bisection by
/// geometry.

#include <array>
#include <vector>

#include <Eigen/Core>

#include "foramen/core/mesh.hpp"

namespace foramen {

/// A part of the graph that is eliminated as one dense block: a separator, or a part too small to be split.
struct DissectionNode {
  std::vector<int> columns;                ///< vertices, in the order of elimination
  std::array<int, 2> children = {-1, -1};  ///< the parts it separates; both -1: a leaf
};

/// In postorder: children stand before their parent, the root last.
using DissectionTree = std::vector<DissectionNode>;

/// Splits the vertices at the median of that coordinate whose separator is smallest, then both halves, down
/// to leaves. A torus needs two cuts at once to fall apart; the separator, being taken from the graph, has
/// both. \param coordinates  one row per vertex: any numbers that tell near from far, e.g. positions in space
/// and on the torus
DissectionTree dissect(const Mesh& mesh, const Eigen::MatrixXd& coordinates);

}  // namespace foramen
