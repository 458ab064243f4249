#pragma once
/// \file
/// Mesh files as bytes, made by simple code, to test readers and writers.

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "foramen/core/mesh.hpp"

namespace foramen::testing {

/// The value's bytes in the given order.
template <class T>
std::string raw(T value, bool big_endian = false) {
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (big_endian != (std::endian::native == std::endian::big))
    bytes = std::string(bytes.rbegin(), bytes.rend());
  return bytes;
}

/// A tetrahedron whose coordinates every number type can represent.
inline TriangleSoup tetrahedron() {
  return {{{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

inline std::string binary_stl(const TriangleSoup& soup, std::string header = "made by a test") {
  header.resize(80, ' ');
  std::string out = header + raw(static_cast<std::uint32_t>(soup.triangles.size()));
  for (const auto& t : soup.triangles) {
    out += raw(0.0F) + raw(0.0F) + raw(0.0F);
    for (int corner : t)
      for (int k = 0; k < 3; ++k) out += raw(static_cast<float>(soup.points[corner][k]));
    out += std::string(2, '\0');
  }
  return out;
}

inline std::string ascii_stl(const TriangleSoup& soup, const std::string& title = "test") {
  std::string out = "solid " + title + "\n";
  for (const auto& t : soup.triangles) {
    out += " facet normal 0 0 0\n  outer loop\n";
    for (int corner : t) {
      const Vec3& p = soup.points[corner];
      out += "   vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
             std::to_string(p.z()) + "\n";
    }
    out += "  endloop\n endfacet\n";
  }
  return out + "endsolid " + title + "\n";
}

/// The coordinates rounded to float32. They are stored in memory, because g++ 12 at -O3 removes a vectorised
/// conversion from double to float and back.
inline TriangleSoup rounded_to_float(TriangleSoup soup) {
  for (Vec3& p : soup.points)
    for (int k = 0; k < 3; ++k) {
      volatile float rounded = static_cast<float>(p[k]);
      p[k] = static_cast<double>(rounded);
    }
  return soup;
}

/// The soup with its points in the order in which triangles first use them, which is the order of a soup read
/// from binary STL.
inline TriangleSoup in_order_of_use(const TriangleSoup& soup) {
  TriangleSoup out;
  std::vector<int> place(soup.points.size(), -1);
  for (const auto& t : soup.triangles) {
    std::array<int, 3> moved{};
    for (std::size_t k = 0; k < 3; ++k) {
      int& p = place[t[k]];
      if (p < 0) {
        p = static_cast<int>(out.points.size());
        out.points.push_back(soup.points[t[k]]);
      }
      moved[k] = p;
    }
    out.triangles.push_back(moved);
  }
  return out;
}

}  // namespace foramen::testing
