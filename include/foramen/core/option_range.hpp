#pragma once
/// \file
/// The range of numbers that an option accepts.

#include <limits>
#include <string>

namespace foramen {

/// An interval of numbers, open or closed at either end. By default it contains every number.
struct OptionRange {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool least_excluded = false, most_excluded = false;

  /// The same interval with a closed upper end; below() gives an open one.
  constexpr OptionRange up_to(double limit) const { return {least, limit, least_excluded, false}; }
  constexpr OptionRange below(double limit) const { return {least, limit, least_excluded, true}; }

  /// Whether it contains the value; no interval contains NaN.
  bool contains(double value) const;
  /// "> 0", "at least 1", "in (0, 1]"; empty for every number.
  std::string text() const;
};

constexpr OptionRange above(double limit) { return {.least = limit, .least_excluded = true}; }
constexpr OptionRange at_least(double limit) { return {.least = limit}; }

}  // namespace foramen
