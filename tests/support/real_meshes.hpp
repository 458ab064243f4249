#pragma once
/// \file
/// Reads the real vertebrae in tests that do not link the io module. It reads only binary little-endian PLY
/// in the form of these files.

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>

#include "foramen/core/mesh.hpp"
#include "support/real_data.hpp"

namespace foramen::testing {

inline Mesh read_real_mesh(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::size_t vertices = 0, faces = 0;
  for (std::string line; std::getline(file, line) && line != "end_header";) {
    std::istringstream words(line);
    std::string key, what;
    std::size_t count = 0;
    words >> key >> what >> count;
    if (key == "element") (what == "vertex" ? vertices : faces) = count;
  }
  constexpr std::size_t vertex_bytes = 12, face_bytes = 13;
  const std::string data{std::istreambuf_iterator<char>(file), {}};
  if (vertices == 0 || data.size() != vertices * vertex_bytes + faces * face_bytes)
    throw std::runtime_error(path.string() + " is not a PLY file of the kind the real vertebrae are");
  TriangleSoup soup;
  const char* at = data.data();
  for (std::size_t v = 0; v < vertices; ++v, at += vertex_bytes) {
    std::array<float, 3> p;
    std::memcpy(p.data(), at, sizeof p);
    soup.points.emplace_back(p[0], p[1], p[2]);
  }
  for (std::size_t f = 0; f < faces; ++f, at += face_bytes) {
    std::array<std::int32_t, 3> t;
    std::memcpy(t.data(), at + 1, sizeof t);
    soup.triangles.push_back({t[0], t[1], t[2]});
  }
  return build_mesh(std::move(soup));
}

/// For example real_mesh("lumbar/verse005_L2").
inline Mesh real_mesh(const std::string& name) { return read_real_mesh(data_dir() / (name + ".ply")); }

}  // namespace foramen::testing
