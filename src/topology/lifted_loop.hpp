#pragma once
// Loops lifted off a surface, and the Gauss integral of two polygons: what linking numbers are computed from.

#include <array>
#include <optional>
#include <vector>

#include "foramen/topology/shortest_loops.hpp"

namespace foramen::topology_detail {

/// How far a loop is pushed off the surface, in lengths of the edge it crosses. Far enough above rounding
/// (1e-16 of the coordinates), near enough not to reach another part of the surface. Two in a row must agree.
inline constexpr std::array pushes{1e-3, 1e-4, 1e-5, 1e-6};

/// \f$ \frac{1}{4\pi} \oint\oint \frac{a - b}{|a - b|^3} \cdot (da \times db) \f$, by segments. Where the
/// polygons touch it is NaN or no integer.
double gauss_integral(const std::vector<Vec3>& a, const std::vector<Vec3>& b);

/// Nothing if it is further than 1e-3 from an integer.
std::optional<int> nearest_integer(double x);

/// The edges crossed by the loop when it is moved a little to its left, into the faces beside it. Each
/// halfedge leaves a vertex of the loop, and is crossed from its own face to its twin's. Unlike the loop,
/// this walk meets no vertex, and shares no edge with any loop.
std::vector<HalfedgeId> crossings_left_of(const Mesh& mesh, const EdgeLoop& loop);

std::vector<Vec3> positions_of(const Mesh& mesh, const EdgeLoop& loop);

/// The walk through the faces left of a loop, lifted outward at the midpoint of each edge it crosses, by
/// `push` lengths of that edge.
std::vector<Vec3> pushed_outward(const Mesh& mesh, const std::vector<HalfedgeId>& crossed, double push);

}  // namespace foramen::topology_detail
