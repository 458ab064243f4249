#pragma once
/// \file
/// Weights that leave out what has no partner.

#include <vector>

namespace foramen {

/// Tukey's biweight \f$ (1 - r^2)^2 \f$ of a distance r times as long as the first that is left out; 0 for
/// r >= 1. \param squared_ratio  r^2
double tukey_weight(double squared_ratio);

/// The value in the middle of the sorted ones, the upper of two. \pre values are not empty
double upper_median(std::vector<double> values);

}  // namespace foramen
