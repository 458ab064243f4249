#pragma once
/// \file
/// Matches of a template's vertices with points of another surface, and what they say of where the vertices
/// lie.

#include <span>

#include "foramen/core/options.hpp"
#include "foramen/match/bending_options.hpp"
#include "match/oriented_points.hpp"

namespace foramen {

/// A vertex of the template and the point of the other surface that is taken for the same.
struct VertexMatch {
  int vertex = -1;
  OrientedPoint partner;
  double distance = 0;  ///< of the search, by position and normal together, mm
  double area_mm2 = 0;  ///< of the surface that the match stands for
};

/// The distance from which matches are left out: rejection * max(median, least_median_mm), mm. The median is
/// that of the matches given, which need not be all that are then weighed. \pre matches are not empty
double match_cut(std::span<const VertexMatch> matches, const MatchOptions& options);

struct MatchScale {
  double noise_mm = 0;  ///< Standard deviation of an independent match across the surface. > 0.
  double cut_mm = 0;    ///< see match_cut(); > 0
};

/// The precision P of a match [mm^-2]: its vertex lies at the partner with an error ~ N(0, P^-1),
///
///     P = w ((1 - s) n n^T + s I),   w = tukey(distance / cut) area / independent_area / (2 noise^2),
///
/// n the mean of both normals, s the tangential share. The 2: both surfaces bring their matches, so every
/// place is seen twice. \param vertex_normal  of the template
Mat3 match_precision(const VertexMatch& match, const Vec3& vertex_normal, const MatchScale& scale,
                     const MatchOptions& options);

}  // namespace foramen
