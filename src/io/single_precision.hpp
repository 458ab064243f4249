#pragma once
/// \file
/// Numbers as a file of single precision gives them back.

namespace foramen {

/// The nearest number of single precision. The detour by a volatile makes sure of it: GCC 12 (-O2) leaves out
/// the rounding where two numbers side by side are converted to float and back.
inline double rounded_to_single(double value) {
  const volatile float single = static_cast<float>(value);
  return static_cast<double>(single);
}

}  // namespace foramen
