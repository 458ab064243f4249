#pragma once
/// \file
/// Linking numbers and the Seifert matrix of loops on a closed surface in space.

#include <vector>

#include "foramen/topology/shortest_loops.hpp"
#include "topology/periods.hpp"

namespace foramen {

/// Gauss linking number of two disjoint closed polygons (the last point joins the first),
/// \f$ \frac{1}{4\pi} \oint\oint \frac{a - b}{|a - b|^3} \cdot (da \times db) \f$: exact sum of solid angles
/// over pairs of segments (\cite arai2013, \cite vanoosterom1983), rounded. +1 when b passes upward through a
/// counter-clockwise a. Throws ConvergenceError if the polygons touch (to rounding), or the sum is further
/// than 1e-3 from an integer.
int linking_number(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// Algebraic intersection number of two loops on a closed surface, in exact arithmetic: +1 where the second
/// passes from the right of the first to its left, seen from outside. They may share edges; either may be any
/// closed walk.
int intersection_number(const Mesh& mesh, const EdgeLoop& first, const EdgeLoop& second);

/// S_kl = lk(loop k, loop l pushed outward off the surface). \pre outward winding (inward gives
/// the transpose, unnoticed). The loops may share edges
/// and retrace themselves. The result is checked: \f$ S - S^T = -I \f$, I_kl the intersection number of k and
/// l, and two distances of the push must agree; ConvergenceError if not. TopologyError if the loops are no
/// basis (intersection number other than +-1).
Eigen::Matrix2i seifert_matrix(const Mesh& mesh, const EdgeLoop& first, const EdgeLoop& second);

/// Whether the change of basis A (columns: the transferred reference loops in the shape's basis) carries one
/// Seifert matrix into the other: A^T S_shape A = S_reference, det A = +1. Leaves only +-A; a Dehn twist, a
/// swap or one sign break it.
bool seifert_test(const Eigen::Matrix2i& a, const Eigen::Matrix2i& shape, const Eigen::Matrix2i& reference);

}  // namespace foramen
