#pragma once
/// \file
/// Matches of a template's vertices with points of another surface, and what they say of where the vertices
/// lie.

#include <span>

#include "foramen/core/options.hpp"
#include "foramen/match/oriented_points.hpp"

namespace foramen {

/// How points of two surfaces are matched and weighed.
struct MatchOptions {
  int samples = 3000;
  double normal_weight = 8.0;
  /// Small, since the closest point says little about where along the surface a vertex belongs.
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
