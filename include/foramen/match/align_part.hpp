#pragma once
/// \file
/// Rigid alignment of a part of a shape with the whole, from any orientation.

#include <vector>

#include "foramen/core/options.hpp"
#include "foramen/match/align.hpp"

namespace foramen {

struct AlignPartOptions {
  double normal_weight = 8.0;
  int rotations = 100;
  int anchors = 6;
  int sample_points = 2000;
  int iteration_limit = 60;
  double tolerance = 1e-3;
  int most_answers = 4;
};
template <class Visitor>
void describe(Visitor& visit, MaybeConst<AlignPartOptions> auto& o) {
  visit(o.normal_weight, {.name = "normal_weight",
                          .unit = "mm",
                          .range = at_least(0),
                          .meaning = "distance that a unit of normal difference counts as in the searches"});
  visit(o.rotations,
        {.name = "rotations", .range = at_least(1), .meaning = "rotations to start from, spread evenly"});
  visit(o.anchors, {.name = "anchors",
                    .range = at_least(1),
                    .meaning = "places of the whole at which the part's centroid starts, for each rotation"});
  visit(o.sample_points, {.name = "sample_points",
                          .range = at_least(1),
                          .meaning = "samples of the part matched in the fine iterations"});
  visit(o.iteration_limit,
        {.name = "iteration_limit", .range = at_least(0), .meaning = "most fine iterations"});
  visit(o.tolerance, {.name = "tolerance",
                      .unit = "mm",
                      .range = at_least(0),
                      .meaning = "largest motion of a sample in an iteration at which the search stops"});
  visit(o.most_answers,
        {.name = "most_answers", .range = at_least(1), .meaning = "most alignments that are returned"});
}

/// Possible alignments of the part with the whole, best first: at most `most_answers`, which differ in
/// rotation by more than 0.2 rad.
///
/// This is one-sided ICP \cite besl1992: each sample of the part is matched with the nearest point of the
/// whole by position and normal, but not vice versa, since most of the whole may be missing in the part.
/// Tukey's biweight removes matches of samples that the whole does not have. The starts are rotations of a
/// super-Fibonacci spiral \cite alexa2022, with the centroid of the part at the centroid of the whole and at
/// points distributed around it. After every few iterations only the better poses are continued.
///
/// Residuals are means over the samples of the part, see Alignment::residual; `second_best` is the residual
/// of the next alignment. The part may be open, in several pieces, or the whole. The result is deterministic.
/// Throws InvalidInput for a surface of zero area and for options out of range.
std::vector<Alignment> align_part(const Mesh& part, const Mesh& whole, const RunContext& ctx,
                                  const AlignPartOptions& options = {});

}  // namespace foramen
