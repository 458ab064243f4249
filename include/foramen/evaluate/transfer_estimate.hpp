#pragma once
/// \file
/// Means over pairs of shapes and how much they vary from subject to subject.

#include <optional>

namespace foramen {

/// A mean over ordered pairs of shapes of different subjects.
struct TransferEstimate {
  double mean = 0;
  /// By the jackknife over subjects \cite efron1981: \f$ \sqrt{\frac{S-1}{S} \sum_s (m_s - \bar m)^2} \f$,
  /// where m_s is the mean over the pairs without subject s, for S subjects. Unset if some m_s has no
  /// pairs, as with two subjects.
  std::optional<double> standard_error;
  int pairs = 0;
};

}  // namespace foramen
