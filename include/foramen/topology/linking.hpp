#pragma once
/// \file
/// Linking numbers and the Seifert matrix of loops on a closed surface in space.

#include <vector>

#include "foramen/topology/shortest_loops.hpp"

namespace foramen {

/// Gauss linking number of two disjoint closed polygons, exact sum of solid angles over pairs of segments, rounded.
/// Throws ConvergenceError if the sum is further than 1e-3 from an integer (the polygons touch).
int linking_number(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// S_kl = lk(loop k, loop l pushed outward off the surface). \pre outward winding. The result is checked:
/// S - S^T must be the intersection form of the loops, +-[[0,1],[-1,0]] for a basis; ConvergenceError if it is not.
Eigen::Matrix2i seifert_matrix(const Mesh& mesh, const EdgeLoop& first, const EdgeLoop& second);

/// Whether the change of basis A (columns: the transferred reference loops in the shape's basis) carries one Seifert
/// matrix into the other: A^T S_shape A = S_reference, det A = +1. Leaves only +-A; a Dehn twist, a swap or one sign break it.
bool seifert_test(const Eigen::Matrix2i& a, const Eigen::Matrix2i& shape, const Eigen::Matrix2i& reference);

}  // namespace foramen
