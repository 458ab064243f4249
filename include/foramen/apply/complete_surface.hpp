#pragma once
/// \file
/// Completion of a shape from a part of its surface: the posterior of the model given the part.

#include <vector>

#include "foramen/apply/shape_distribution.hpp"
#include "foramen/core/options.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/match/align_part.hpp"
#include "foramen/match/bending_options.hpp"
#include "foramen/model/procrustes.hpp"

namespace foramen {

struct CompleteSurfaceOptions {
  /// ScaleMode of the model; with ScaleMode::remove the size of the part is fitted, too.
  ScaleMode scale = ScaleMode::keep;
  /// Standard deviation of the distance between the part and the surface of the shape, in the normal
  /// direction [mm]. > 0.
  double noise_mm = 0.5;
  MatchOptions match = {.samples = 2000};  ///< The number of samples holds for the part.
  /// Variance of the deformations of shapes that no mode describes, as a share of the variance of the smooth
  /// process; 0: the modes only.
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

/// The result of complete_surface().
struct CompletedSurface {
  SimilarityTransform to_model;  ///< maps coordinates of the part to those of the model
  ShapeDistribution shape;  ///< posterior of all landmarks given the part, in the coordinates of the part, mm
  std::vector<bool> seen;   ///< per landmark: whether it was matched with a point of the part
  double distance_mm = 0;   ///< mean distance of the samples of the part to the mean of `shape`
  /// Share of the samples of the part that were matched; the others do not belong to the shape.
  double matched_share = 0;
  /// The mean distance for the next best pose. If it is close to `distance_mm`, the pose is ambiguous.
  /// Infinity: there is no other pose.
  double second_best_mm = 0;
};

/// The posterior of the model given a part of a surface \cite albrecht2013, open or damaged, in any pose.
///
/// The model is fitted from each of the poses that align_part() returns, and the fit with the smallest
/// distance of the part's samples is kept.
///
/// Each fit goes from coarse to fine noise. In each iteration every sample of the part is matched with the
/// nearest landmark by position and normal, and every landmark with the nearest point of the part. A landmark
/// whose nearest point lies at an open border of the part is not matched, because it probably lies beyond the
/// border. Tukey's biweight, scaled by the distances of the part's samples, removes matches of parts that the
/// other surface does not have. Given the matches, the posterior (posterior_coefficients()) is exact for
///
///     x = mean + basis b + pose + smooth,   b ~ N(0, variance),
///
/// where `pose` is a small motion (and change of size) relative to the previous pose, with a wide prior. It
/// is solved together with the shape, so the spread of the result includes its uncertainty. `smooth` is given
/// by smooth_columns(). The precision of a match is that of match_precision(). The result is deterministic
/// and moves with the part, up to the tolerance of the search. Throws InvalidInput for a part of zero area
/// and for options out of range.
CompletedSurface complete_surface(const Mesh& part, const ShapeModel& model, const RunContext& ctx,
                                  const CompleteSurfaceOptions& options = {});

}  // namespace foramen
