#pragma once
/// \file
/// Torus positions in fixed-point arithmetic, so that orientation tests on the torus are exact.

#include <cmath>
#include <cstdint>

#include "foramen/core/error.hpp"
#include "foramen/core/mesh.hpp"

namespace foramen::detail {

/// Positions are multiples of 2^-40 turns, like those of quantised() maps; this is about 1e-10 mm on a
/// vertebra.
inline constexpr int fixed_bits = 40;
inline constexpr std::int64_t fixed_turn = std::int64_t{1} << fixed_bits;
/// Beyond this many turns a double cannot represent all multiples of 2^-40 turns.
inline constexpr double largest_turns = 4096;

__extension__ typedef __int128 Int128;

/// A position on the torus or a difference of positions, in multiples of 2^-40 turns.
struct Fixed2 {
  std::int64_t x = 0, y = 0;
  friend constexpr Fixed2 operator+(Fixed2 a, Fixed2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Fixed2 operator-(Fixed2 a, Fixed2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Fixed2 operator-(Fixed2 a) { return {-a.x, -a.y}; }
  friend constexpr bool operator==(Fixed2, Fixed2) = default;
};

inline bool representable(const Vec2& turns) {
  return std::abs(turns.x()) < largest_turns && std::abs(turns.y()) < largest_turns;  // false for NaN too
}

inline Fixed2 to_fixed(const Vec2& turns) {
  constexpr double scale = static_cast<double>(fixed_turn);
  return {std::llround(turns.x() * scale), std::llround(turns.y() * scale)};
}

inline Fixed2 whole_turns(const Vec2i& count) { return {count.x() * fixed_turn, count.y() * fixed_turn}; }

inline Vec2 to_turns(Fixed2 p) {
  constexpr double scale = static_cast<double>(fixed_turn);
  return {static_cast<double>(p.x) / scale, static_cast<double>(p.y) / scale};
}

/// The whole turns below a position, so that p - floor is in [0, 1)^2.
inline Vec2i floor_turns(Fixed2 p) {
  return {static_cast<int>(p.x >> fixed_bits), static_cast<int>(p.y >> fixed_bits)};
}

inline Int128 cross(Fixed2 a, Fixed2 b) { return Int128{a.x} * b.y - Int128{a.y} * b.x; }

/// Twice the signed area, exactly.
inline Int128 orientation(Fixed2 a, Fixed2 b, Fixed2 c) { return cross(b - a, c - a); }

}  // namespace foramen::detail
