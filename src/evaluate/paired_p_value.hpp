#pragma once
/// \file
/// A permutation test for the mean of paired differences.

#include <span>

namespace foramen {

/// Up to this many differences all sign patterns are enumerated; for more, random patterns are drawn.
inline constexpr int most_enumerated_differences = 20;
inline constexpr int random_sign_patterns = 99999;

/// The two-sided p-value of the sign-flip permutation test \cite fisher1935 for differences d_1 .. d_n. Under
/// the null hypothesis each difference has either sign with equal probability, independently: \f$ p = \#\{ s
/// \in \{-1,1\}^n : |\sum_i s_i d_i| \ge |\sum_i d_i| \} / 2^n \f$. It is exact for up to
/// most_enumerated_differences differences. For more, it is (1 + k) / (1 + N), where k of N =
/// random_sign_patterns random patterns (fixed seed) satisfy the inequality \cite phipson2010. The exact
/// value is never below 2 / 2^n; for example, three differences cannot give less than 0.25. Sums are compared
/// exactly in units of 2^-40 of the largest difference, so rounding cannot break ties. Throws InvalidInput if
/// there is no difference or one is not finite.
double paired_p_value(std::span<const double> differences);

}  // namespace foramen
