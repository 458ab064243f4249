#include "foramen/core/options.hpp"

#include <cmath>
#include <cstdio>

namespace foramen {
namespace {

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  if (std::abs(number) < 1e15 && number == std::floor(number))  // 100000, not 1e+05
    std::snprintf(text, sizeof text, "%.0f", number);
  return text;
}

}  // namespace

bool OptionRange::contains(double value) const {
  const bool high_enough = least_excluded ? value > least : value >= least;
  const bool low_enough = most_excluded ? value < most : value <= most;
  return high_enough && low_enough;
}

std::string OptionRange::text() const {
  const bool bounded_below = std::isfinite(least), bounded_above = std::isfinite(most);
  if (bounded_below && bounded_above)
    return std::string("in ") + (least_excluded ? "(" : "[") + text_of(least) + ", " + text_of(most) +
           (most_excluded ? ")" : "]");
  if (bounded_below) return (least_excluded ? "> " : "at least ") + text_of(least);
  if (bounded_above) return (most_excluded ? "< " : "at most ") + text_of(most);
  return {};
}

}  // namespace foramen
