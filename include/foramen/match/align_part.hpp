#pragma once
/// \file
/// Rigid alignment of a part of a shape with the whole, from any orientation.

#include <vector>

#include "foramen/match/align.hpp"

namespace foramen {

struct AlignPartOptions {
  double normal_weight = 8.0;  ///< mm per unit of normal difference in the 6-D neighbour search. >= 0.
  int rotations = 100;         ///< Starts: rotations spread evenly, > 0, ...
  int anchors = 6;             ///< ... each with the part's centroid at so many places of the whole. > 0.
  int sample_points = 2000;    ///< of the part, matched in the fine iterations. > 0.
  int iteration_limit = 60;    ///< of the fine iterations. >= 0.
  double tolerance = 1e-3;     ///< Stops when an iteration moves no sample by more than this [mm].
  int most_answers = 4;        ///< > 0
};

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
