#pragma once
/// \file
/// An encoding of small triangle soups in which most sequences of bytes are a soup.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "foramen/core/mesh.hpp"

namespace foramen::fuzzing {

inline constexpr double soup_step_mm = 1.0 / 16;

/// Encodes a soup: the number of points in one byte, each coordinate as a number of steps in two bytes, each
/// corner in one byte.
inline std::string soup_bytes(const TriangleSoup& soup) {
  std::string bytes(1, static_cast<char>(soup.points.size()));
  for (const Vec3& p : soup.points)
    for (int k = 0; k < 3; ++k) {
      const auto steps =
          static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lround(p[k] / soup_step_mm)));
      bytes += static_cast<char>(steps & 0xff);
      bytes += static_cast<char>(steps >> 8);
    }
  for (const auto& triangle : soup.triangles)
    for (const int corner : triangle) bytes += static_cast<char>(corner);
  return bytes;
}

/// Decodes any bytes. Corners may be indices of points that do not exist.
inline TriangleSoup soup_from(std::string_view bytes) {
  TriangleSoup soup;
  const auto byte = [&](std::size_t i) {
    return static_cast<unsigned>(static_cast<unsigned char>(bytes[i]));
  };
  if (bytes.empty()) return soup;
  std::size_t at = 1;
  for (unsigned n = byte(0); n > 0 && at + 6 <= bytes.size(); --n) {
    Vec3 p = Vec3::Zero();
    for (int k = 0; k < 3; ++k, at += 2)
      p[k] =
          soup_step_mm * static_cast<std::int16_t>(static_cast<std::uint16_t>(byte(at) | byte(at + 1) << 8));
    soup.points.push_back(p);
  }
  for (; at + 3 <= bytes.size(); at += 3)
    soup.triangles.push_back(
        {static_cast<int>(byte(at)), static_cast<int>(byte(at + 1)), static_cast<int>(byte(at + 2))});
  return soup;
}

}  // namespace foramen::fuzzing
