#pragma once
/// \file
/// Matches of template vertices with points of another surface, and their precision.

#include <span>

#include "foramen/core/options.hpp"
#include "foramen/match/bending_options.hpp"
#include "match/oriented_points.hpp"

namespace foramen {

/// A vertex of the template and its corresponding point on the other surface.
struct VertexMatch {
  int vertex = -1;
  OrientedPoint partner;
  double distance = 0;  ///< distance in the search by position and normal, mm
  double area_mm2 = 0;  ///< area of the surface that the match represents
};

/// The distance from which on matches are rejected: rejection * max(median, least_median_mm), mm, with the
/// median distance of the given matches. Other matches may be weighted by it, too. \pre matches are not
/// empty
double match_cut(std::span<const VertexMatch> matches, const MatchOptions& options);

/// The noise and the rejection distance of a set of matches.
struct MatchScale {
  double noise_mm = 0;  ///< Standard deviation of an independent match in the normal direction. > 0.
  double cut_mm = 0;    ///< see match_cut(); > 0
};

/// The precision P of a match [mm^-2]. The vertex is at the partner with an error ~ N(0, P^-1), where
///
///     P = w ((1 - s) n n^T + s I),   w = tukey(distance / cut) area / independent_area / (2 noise^2),
///
/// n is the mean of both normals and s = min(1, tangential_share + curved_share c_1 c_2) with the
/// curvedness c of both points. The factor 2 accounts for matches from both surfaces, which observe each
/// place twice.
/// \param at_vertex  the template at the vertex
Mat3 match_precision(const VertexMatch& match, const OrientedPoint& at_vertex, const MatchScale& scale,
                     const MatchOptions& options);

}  // namespace foramen
