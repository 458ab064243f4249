#pragma once
/// \file
/// Whether paired differences have a sign of their own.

#include <span>

namespace foramen {

/// All sign patterns are gone through for so many differences; beyond, random ones are.
inline constexpr int most_enumerated_differences = 20;
inline constexpr int random_sign_patterns = 99999;

/// The two-sided p-value of the sign-flip permutation test \cite fisher1935 of differences d_1 .. d_n, which
/// under the null hypothesis would as likely have come out with the other sign, each by itself:
/// \f$ p = \#\{ s \in \{-1,1\}^n : |\sum_i s_i d_i| \ge |\sum_i d_i| \} / 2^n \f$. Exact up to
/// most_enumerated_differences; beyond, (1 + k) / (1 + N), k being the patterns counted of N =
/// random_sign_patterns drawn from a fixed seed \cite phipson2010. Never below 2 / 2^n: three differences
/// cannot give less than 0.25. Sums are compared in units of 2^-40 of the largest difference, exactly, so
/// that a tie is a tie whatever the last digits. Throws InvalidInput for no difference, or one that is not
/// finite.
double paired_p_value(std::span<const double> differences);

}  // namespace foramen
