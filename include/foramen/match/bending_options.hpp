#pragma once
/// \file
/// How a template is bent onto a shape: options of smooth_displacements(), of matches and of
/// deform_template().

#include <vector>

#include "foramen/core/options.hpp"

namespace foramen {

/// One term of the covariance of each coordinate: amplitude^2 exp(-r^2 / (2 length^2)).
struct DisplacementScale {
  double length_mm = 10;
  double amplitude_mm = 1;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<DisplacementScale> auto& o) {
  visit(o.length_mm, {.name = "length",
                      .unit = "mm",
                      .range = above(0),
                      .meaning = "distance over which displacements are alike"});
  visit(o.amplitude_mm, {.name = "amplitude",
                         .unit = "mm",
                         .range = above(0),
                         .meaning = "standard deviation of a coordinate"});
}

struct SmoothDisplacementOptions {
  /// From displacements of large parts of a vertebra to displacements of the tip of a process.
  std::vector<DisplacementScale> scales = {{40, 4}, {20, 1.5}, {10, 0.5}};
  double shift_mm = 10;
  double linear_mm = 6;
  double left_out_mm = 0.3;
  int most_functions = 400;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<SmoothDisplacementOptions> auto& o) {
  visit(o.scales, {.name = "scales", .meaning = "parts of the covariance"});
  visit(o.shift_mm, {.name = "shift",
                     .unit = "mm",
                     .range = above(0),
                     .meaning = "standard deviation of a common translation"});
  visit(o.linear_mm,
        {.name = "linear",
         .unit = "mm",
         .range = above(0),
         .meaning = "standard deviation of a linear map's displacement at the surface's RMS radius"});
  visit(o.left_out_mm,
        {.name = "left_out",
         .unit = "mm",
         .range = above(0),
         .meaning = "the basis ends when no point's standard deviation left out is above this"});
  visit(o.most_functions,
        {.name = "functions_limit", .range = at_least(1), .meaning = "most functions of the basis"});
}

/// How points of two surfaces are matched and weighted.
struct MatchOptions {
  int samples = 3000;
  double normal_weight = 8.0;
  /// Small, because a closest point says little about the position of a vertex along the surface.
  double tangential_share = 0.05;
  double curved_share = 0.4;
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
  visit(o.curved_share,
        {.name = "curved_share",
         .range = at_least(0),
         .meaning = "what is added to this part where both surfaces are curved, as along a rim"});
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

struct DeformTemplateOptions {
  std::vector<double> noise_mm = {4, 2, 1, 0.5, 0.25};  ///< Not empty.
  int iterations = 4;
  MatchOptions match = {};  ///< The number of samples holds for each of the two surfaces.
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<DeformTemplateOptions> auto& o) {
  visit(o.noise_mm, {.name = "noise",
                     .unit = "mm",
                     .range = above(0),
                     .meaning = "standard deviation of a match, from coarse to fine"});
  visit(o.iterations,
        {.name = "iterations", .range = at_least(1), .meaning = "iterations at every level of noise"});
  visit(o.match, {.nesting = Nesting::inlined});
}

}  // namespace foramen
