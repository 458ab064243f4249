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

/// Where the part may lie on the whole, the best first: at most `most_answers` alignments that differ in
/// rotation by more than 0.2 rad. ICP \cite besl1992 that asks of every sample of the part for the whole's
/// nearest point by position and normal, and never the other way round, since most of the whole may be
/// missing; Tukey's weights leave out what the whole does not have. Starts are rotations of a super-Fibonacci
/// spiral \cite alexa2022 with the part's centroid at the whole's and at points spread over it; after each
/// few iterations only the better ones go on. Residuals are means over the part's samples, see
/// Alignment::residual; `second_best` is the next answer's. The part may be open, in several pieces, or the
/// whole. Deterministic. Throws InvalidInput for a surface without area or an option out of its range.
std::vector<Alignment> align_part(const Mesh& part, const Mesh& whole, const RunContext& ctx,
                                  const AlignPartOptions& options = {});

}  // namespace foramen
