#pragma once

#include <cstdio>
#include <string>

namespace foramen {

/// The number in fixed-point notation.
inline std::string plain_number(double value, int digits) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

}  // namespace foramen
