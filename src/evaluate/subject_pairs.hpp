#pragma once
/// \file
/// Ordered pairs of shapes of different subjects, and means over them.

#include <string>
#include <utility>
#include <vector>

#include "foramen/evaluate/transfer_estimate.hpp"

namespace foramen::detail {

/// A value of an ordered pair of shapes.
struct PairValue {
  int from = 0, to = 0;
  double value = 0;
};

/// The subjects of shapes, as numbers.
class PairSubjects {
 public:
  /// \param subjects  the subject of each shape; empty: every shape is a subject of its own
  PairSubjects(int shapes, const std::vector<std::string>& subjects);

  int of(int shape) const { return of_shape_[shape]; }
  bool differ(int a, int b) const { return of(a) != of(b); }

 private:
  std::vector<int> of_shape_;
};

/// The mean of the values with the jackknife over the subjects that they belong to. \pre at least one value
TransferEstimate mean_over_pairs(const std::vector<PairValue>& values, const PairSubjects& subjects);

/// The mean over groups (as regions) of the mean over the pairs of each, with the jackknife over subjects. A
/// group without pairs is left out. `pairs` counts those with a value in any group. \pre at least one value
TransferEstimate mean_over_groups(const std::vector<std::vector<PairValue>>& groups,
                                  const PairSubjects& subjects);

}  // namespace foramen::detail
