#pragma once
/// \file
/// A whole shape from a part of its surface: the model given what is seen.

#include <vector>

#include "foramen/apply/shape_distribution.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/match/align_part.hpp"
#include "foramen/match/bending_options.hpp"
#include "foramen/model/procrustes.hpp"

namespace foramen {

struct CompleteSurfaceOptions {
  ScaleMode scale = ScaleMode::keep;  ///< Of the model; remove: the part's size is fitted too.
  /// Standard deviation of the part's surface about the shape's, across the surface [mm]. > 0.
  double noise_mm = 0.5;
  MatchOptions match = {.samples = 2000};  ///< Its samples are of the part.
  /// Variance of what shapes have beyond the modes, as a share of the smooth process; 0: the modes alone.
  double beyond_modes = 0.3;
  SmoothDisplacementOptions smooth = {.scales = {{40, 4}, {20, 1.5}}, .left_out_mm = 0.6};
  AlignPartOptions pose = {};
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<CompleteSurfaceOptions> auto& o) {
  visit(o.scale,
        {.name = "scale",
         .meaning = "whether the model keeps sizes; if it removes them, the part's size is fitted too"});
  visit(o.noise_mm, {.name = "noise",
                     .unit = "mm",
                     .range = above(0),
                     .meaning = "standard deviation of the surface about the shape"});
  visit(o.match, {.name = "match"});
  visit(o.beyond_modes,
        {.name = "beyond_modes",
         .range = at_least(0),
         .meaning =
             "variance of smooth displacements that no mode has, as a share of the prior's; 0: the modes "
             "alone"});
  visit(o.smooth, {.name = "smooth"});
  visit(o.pose, {.name = "pose"});
}

struct CompletedSurface {
  SimilarityTransform to_model;  ///< part's coordinates -> the model's
  ShapeDistribution shape;       ///< of all landmarks given the part, in the part's coordinates, mm
  std::vector<bool> seen;        ///< per landmark: whether a point of the part was matched with it
  double distance_mm = 0;        ///< mean distance of the part's samples to the mean of `shape`
  double matched_share = 0;      ///< of the part's samples: the rest are not of the shape
  /// The same mean for the next best pose: close to `distance_mm` = ambiguous. Infinity: no other pose.
  double second_best_mm = 0;
};

/// The posterior of the model given a part of a surface \cite albrecht2013, open or damaged, in any pose.
///
/// The pose is sought with align_part(), and the model fitted from each of its answers; the one that leaves
/// the part's samples the closest is kept. Then, from coarse to fine noise: every sample of the part and the
/// nearest landmark by position and normal, and every landmark and the nearest point of the part, unless that
/// lies at an open border (what a landmark beyond the border has there is not its own), are taken for one;
/// Tukey's weights by the distances of the part's samples leave out what the other surface does not have.
/// Given these matches the posterior is exact (posterior_coefficients()) of
///
///     x = mean + basis b + pose + smooth,   b ~ N(0, variance),
///
/// pose a small motion (and size) about the last one, with a wide prior, solved together with the shape and
/// so part of its spread; smooth as in smooth_columns(). Every match across the surface has the noise divided
/// by the root of its share of an independent patch. Deterministic; moves with the part, to the tolerance of
/// the search. Throws InvalidInput for a part without area or an option out of its range.
CompletedSurface complete_surface(const Mesh& part, const ShapeModel& model, const RunContext& ctx,
                                  const CompleteSurfaceOptions& options = {});

}  // namespace foramen
