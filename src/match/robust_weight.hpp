#pragma once
/// \file
/// Robust weights, which remove points without partner.

#include <vector>

namespace foramen {

/// Tukey's biweight \f$ (1 - r^2)^2 \f$, 0 for r >= 1, where r is a distance divided by the rejection
/// distance.
/// \param squared_ratio  r^2
double tukey_weight(double squared_ratio);

/// The median; for an even number of values the upper one of the two in the middle. \pre values are not empty
double upper_median(std::vector<double> values);

}  // namespace foramen
