#pragma once
// Loops pushed off a surface and the Gauss integral of two polygons, from which linking numbers are computed.

#include <array>
#include <optional>
#include <vector>

#include "foramen/topology/shortest_loops.hpp"

namespace foramen::topology_detail {

/// Distances by which a loop is pushed off the surface, in lengths of the crossed edge. They must be far
/// above rounding (1e-16 of the coordinates) and too small to reach another part of the surface. The linking
/// numbers of two successive distances must agree.
inline constexpr std::array pushes{1e-3, 1e-4, 1e-5, 1e-6};

/// \f$ \frac{1}{4\pi} \oint\oint \frac{a - b}{|a - b|^3} \cdot (da \times db) \f$, by segments. Where the
/// polygons touch it is NaN or no integer.
double gauss_integral(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// The nearest integer; nullopt if x differs from it by more than 1e-3.
std::optional<int> nearest_integer(double x);

/// The edges that the loop crosses when it is moved slightly to its left. Each returned halfedge starts at a
/// vertex of the loop and is crossed from its own face to that of its twin. Unlike the loop, this walk passes
/// through no vertex and runs along no edge.
std::vector<HalfedgeId> crossings_left_of(const Mesh& mesh, const EdgeLoop& loop);

std::vector<Vec3> positions_of(const Mesh& mesh, const EdgeLoop& loop);

/// The polygon through the midpoints of the crossed edges, each moved outward by `push` lengths of its edge.
std::vector<Vec3> pushed_outward(const Mesh& mesh, const std::vector<HalfedgeId>& crossed, double push);

}  // namespace foramen::topology_detail
