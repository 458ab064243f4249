#pragma once
/// \file
/// The overlap of regions that people marked on the surfaces, in correspondence.

#include <optional>
#include <string>
#include <vector>

#include "foramen/core/marks.hpp"
#include "foramen/core/run_context.hpp"
#include "foramen/evaluate/cohort.hpp"
#include "foramen/evaluate/transfer_estimate.hpp"

namespace foramen {

/// The Dice coefficient of one region over all pairs in which both shapes have it, 0 .. 1.
struct RegionOverlap {
  std::string region;
  TransferEstimate dice;
};

/// The mean over the regions of one ordered pair of shapes.
struct RegionPair {
  int from = 0, to = 0;  ///< shapes of the cohort
  double dice = 0;
};

/// The result of region_transfer().
struct RegionTransfer {
  TransferEstimate dice;  ///< mean over regions of their means over pairs
  std::vector<RegionOverlap> by_region;
  std::vector<RegionPair> pairs;  ///< by `from`, then by `to`; those with a region in common
  int labelled_shapes = 0;
};

/// Each vertex of the corresponding meshes is in the region of the input vertex that is closest to it. For
/// a pair of shapes, the Dice coefficient \cite dice1945 of region r is \f$ 2 w(A_r \cap B_r) / (w(A_r) +
/// w(B_r)) \f$, where A_r and B_r are the vertices in it on the two shapes, and each vertex has as weight w
/// the mean of its areas on the two corresponding meshes. Pairs are the ordered pairs of shapes of
/// different subjects (of all shapes, if subjects are not known). A region counts in pairs in which both
/// inputs have it.
///
/// \param regions  one entry per shape; without names for a shape without regions
/// Throws InvalidInput if a shape has not one label per vertex of its input, or no two shapes of different
/// subjects have a region in common.
RegionTransfer region_transfer(const CorrespondingCohort& cohort, const std::vector<RegionsOfShape>& regions,
                               const RunContext& ctx);

}  // namespace foramen
