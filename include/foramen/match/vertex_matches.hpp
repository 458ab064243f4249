#pragma once
/// \file
/// Matches of template vertices with points of another surface, and their precision.

#include <span>

#include "foramen/core/options.hpp"
#include "foramen/match/oriented_points.hpp"

namespace foramen {

/// How points of two surfaces are matched and weighted.
struct MatchOptions {
  int samples = 3000;
  double normal_weight = 8.0;
  /// Small, because a closest point says little about the position of a vertex along the surface.
  double tangential_share = 0.05;
  double independent_area_mm2 = 20;
  double rejection = 4;
  double least_median_mm = 0.5;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<MatchOptions> auto& o) {
  visit(o.samples, {.name = "samples",
                    .range = at_least(1),
                    .meaning = "points of a surface that look for a partner on the other"});
  visit(o.normal_weight, {.name = "normal_weight",
                          .unit = "mm",
                          .range = at_least(0),
                          .meaning = "distance that a unit of normal difference counts as in the searches"});
  visit(o.tangential_share, {.name = "tangential_share",
                             .range = above(0).up_to(1),
                             .meaning = "part of a match's precision that also holds along the surface"});
  visit(o.independent_area_mm2, {.name = "independent_area",
                                 .unit = "mm^2",
                                 .range = above(0),
                                 .meaning = "area of a patch that counts as one independent match"});
  visit(o.rejection, {.name = "rejection",
                      .unit = "medians",
                      .range = above(0),
                      .meaning = "matches at least this far apart are left out (Tukey's biweight)"});
  visit(o.least_median_mm, {.name = "least_median",
                            .unit = "mm",
                            .range = above(0),
                            .meaning = "the median counts as no less than this"});
}

/// A vertex of the template and its corresponding point on the other surface.
struct VertexMatch {
  int vertex = -1;
  OrientedPoint partner;
  double distance = 0;  ///< distance in the search by position and normal, mm
  double area_mm2 = 0;  ///< area of the surface that the match represents
};

/// The distance from which on matches are rejected: rejection * max(median, least_median_mm), mm, with the
/// median distance of the given matches. Other matches may be weighted by it, too. \pre matches are not empty
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
/// n is the mean of both normals and s the tangential share. The factor 2 accounts for matches from both
/// surfaces, which observe each place twice.
/// \param vertex_normal  normal of the template at the vertex
Mat3 match_precision(const VertexMatch& match, const Vec3& vertex_normal, const MatchScale& scale,
                     const MatchOptions& options);

}  // namespace foramen
