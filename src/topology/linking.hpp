#pragma once
/// \file
/// Linking numbers and the Seifert matrix of loops on a closed surface in space.

#include <vector>

#include "foramen/topology/shortest_loops.hpp"
#include "topology/periods.hpp"

namespace foramen {

/// Gauss linking number of two disjoint closed polygons (the last point joins the first), \f$ \frac{1}{4\pi}
/// \oint\oint \frac{a - b}{|a - b|^3} \cdot (da \times db) \f$: computed as a sum of solid angles over pairs
/// of segments (\cite arai2013, \cite vanoosterom1983) and rounded to an integer. It is +1 if b passes upward
/// through a counter-clockwise a. Throws ConvergenceError if the polygons touch up to rounding or the sum
/// differs from an integer by more than 1e-3.
int linking_number(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// Algebraic intersection number of two loops on a closed surface, in exact arithmetic: a crossing counts +1
/// if the second loop passes from the right of the first to its left, seen from outside. Both may be any
/// closed walks and may share edges.
int intersection_number(const Mesh& mesh, const EdgeLoop& first, const EdgeLoop& second);

/// The Seifert matrix S_kl = lk(loop k, loop l pushed outward off the surface). The loops may share edges and
/// retrace themselves. The result is verified: \f$ S - S^T = -I \f$ must hold, where I_kl is the intersection
/// number of loops k and l, and two distances of the push must give the same matrix. Throws ConvergenceError
/// otherwise, and TopologyError if the loops are not a basis (intersection number other than +-1).
/// \pre outward winding; inward winding gives the transpose, which is not detected
Eigen::Matrix2i seifert_matrix(const Mesh& mesh, const EdgeLoop& first, const EdgeLoop& second);

/// Whether the change of basis A maps one Seifert matrix to the other: A^T S_shape A = S_reference and det A
/// = +1. The columns of A are the transferred reference loops in the basis of the shape. The test determines
/// A up to sign; a Dehn twist, exchanged loops and one reversed loop fail it.
bool seifert_test(const Eigen::Matrix2i& a, const Eigen::Matrix2i& shape, const Eigen::Matrix2i& reference);

}  // namespace foramen
