#pragma once
/// \file
/// Label maps of known shapes, and their files as bytes, for tests.

#include <array>
#include <cstdint>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <zlib.h>

#include "foramen/io/label_map.hpp"

namespace foramen::testing {

/// A lattice of this size whose middle is at the origin of LPS space. A function of the centre of a voxel
/// gives its label.
inline LabelMap labelled_lattice(const std::array<int, 3>& size, const Mat3& axes,
                                 const std::function<int(const Vec3&)>& label_at) {
  LabelMap map;
  map.size = size;
  map.axes = axes;
  map.origin = -axes * (Vec3(size[0] - 1, size[1] - 1, size[2] - 1) / 2);
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j)
      for (int i = 0; i < size[0]; ++i)
        map.labels.push_back(static_cast<std::uint16_t>(label_at(map.origin + axes * Vec3(i, j, k))));
  return map;
}

/// An approximate signed distance [mm] to a torus about z with a bump. No rotation or reflection maps this
/// torus to itself.
inline double bumpy_torus(const Vec3& p, double major_mm = 16, double minor_mm = 6) {
  const double ring = std::hypot(p.x(), p.y()) - major_mm;
  const double torus = std::hypot(ring, p.z()) - minor_mm;
  const double bump = (p - Vec3(major_mm, 5, minor_mm)).norm() - 5;
  return std::min(torus, bump);
}

template <class T>
void append_value(std::string& bytes, T value, bool big_endian = false) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += raw[big_endian ? sizeof(T) - 1 - i : i];
}

template <class T>
void set_value(std::string& bytes, std::size_t offset, T value, bool big_endian = false) {
  std::string raw;
  append_value(raw, value, big_endian);
  for (std::size_t i = 0; i < raw.size(); ++i) bytes.at(offset + i) = raw[i];
}

template <class T>
std::string voxel_bytes(const LabelMap& map, bool big_endian = false) {
  std::string bytes;
  for (const std::uint16_t label : map.labels) append_value(bytes, static_cast<T>(label), big_endian);
  return bytes;
}

/// The bytes compressed by gzip, or by zlib as in MetaImage.
inline std::string packed(const std::string& bytes, bool gzip = true) {
  z_stream z{};
  deflateInit2(&z, Z_BEST_SPEED, Z_DEFLATED, gzip ? 15 + 16 : 15, 8, Z_DEFAULT_STRATEGY);
  std::string out(deflateBound(&z, bytes.size()) + 64, '\0');
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  z.avail_out = static_cast<uInt>(out.size());
  deflate(&z, Z_FINISH);
  out.resize(z.total_out);
  deflateEnd(&z);
  return out;
}

/// The map as NIfTI-1, with its geometry as sform (RAS). T must be the C++ type of the NIfTI type.
template <class T = std::uint16_t>
std::string nifti_bytes(const LabelMap& map, int type = 512, bool big_endian = false) {
  std::string h(352, '\0');
  set_value<std::int32_t>(h, 0, 348, big_endian);
  set_value<std::int16_t>(h, 40, 3, big_endian);
  for (std::size_t d = 0; d < 3; ++d)
    set_value<std::int16_t>(h, 42 + 2 * d, static_cast<std::int16_t>(map.size[d]), big_endian);
  for (std::size_t d = 3; d < 7; ++d) set_value<std::int16_t>(h, 42 + 2 * d, 1, big_endian);
  set_value<std::int16_t>(h, 70, static_cast<std::int16_t>(type), big_endian);
  set_value<std::int16_t>(h, 72, 8 * sizeof(T), big_endian);
  set_value<float>(h, 76, 1, big_endian);
  for (int d = 0; d < 3; ++d)
    set_value<float>(h, 80 + 4 * static_cast<std::size_t>(d), static_cast<float>(map.axes.col(d).norm()),
                     big_endian);
  set_value<float>(h, 108, 352, big_endian);
  set_value<std::int16_t>(h, 254, 1, big_endian);
  for (int row = 0; row < 3; ++row) {
    const double sign = row < 2 ? -1 : 1;
    const std::size_t at = 280 + 16 * static_cast<std::size_t>(row);
    for (int d = 0; d < 3; ++d)
      set_value<float>(h, at + 4 * static_cast<std::size_t>(d), static_cast<float>(sign * map.axes(row, d)),
                       big_endian);
    set_value<float>(h, at + 12, static_cast<float>(sign * map.origin[row]), big_endian);
  }
  h.replace(344, 4, std::string("n+1\0", 4));
  return h + voxel_bytes<T>(map, big_endian);
}

/// The map as NIfTI-2 of uint16, placed by its sform.
inline std::string nifti2_bytes(const LabelMap& map, bool big_endian = false) {
  std::string h(544, '\0');
  set_value<std::int32_t>(h, 0, 540, big_endian);
  h.replace(4, 8, std::string("n+2\0\r\n\x1a\n", 8));
  set_value<std::int16_t>(h, 12, 512, big_endian);
  set_value<std::int16_t>(h, 14, 16, big_endian);
  set_value<std::int64_t>(h, 16, 3, big_endian);
  for (std::size_t d = 0; d < 3; ++d) set_value<std::int64_t>(h, 24 + 8 * d, map.size[d], big_endian);
  for (std::size_t d = 3; d < 7; ++d) set_value<std::int64_t>(h, 24 + 8 * d, 1, big_endian);
  set_value<std::int64_t>(h, 168, 544, big_endian);
  set_value<std::int32_t>(h, 348, 1, big_endian);
  for (int row = 0; row < 3; ++row) {
    const double sign = row < 2 ? -1 : 1;
    const std::size_t at = 400 + 32 * static_cast<std::size_t>(row);
    for (int d = 0; d < 3; ++d)
      set_value<double>(h, at + 8 * static_cast<std::size_t>(d), sign * map.axes(row, d), big_endian);
    set_value<double>(h, at + 24, sign * map.origin[row], big_endian);
  }
  return h + voxel_bytes<std::uint16_t>(map, big_endian);
}

inline std::string numbers(const Vec3& v, const char* between) {
  char text[128];
  std::snprintf(text, sizeof text, "%.17g%s%.17g%s%.17g", v.x(), between, v.y(), between, v.z());
  return text;
}

inline std::string sizes_of(const LabelMap& map) {
  return std::to_string(map.size[0]) + " " + std::to_string(map.size[1]) + " " + std::to_string(map.size[2]);
}

/// The header of an NRRD file of uint16, little endian, in that space, up to the encoding and the blank line.
inline std::string nrrd_header(const LabelMap& map, const std::string& space = "left-posterior-superior",
                               const Vec3& signs = Vec3::Ones()) {
  const auto vector = [&](const Vec3& v) {
    return std::string("(").append(numbers(signs.cwiseProduct(v), ",")).append(")");
  };
  return "NRRD0004\n# a comment\ntype: unsigned short\ndimension: 3\nspace: " + space +
         "\nsizes: " + sizes_of(map) + "\nspace directions: " + vector(map.axes.col(0)) + " " +
         vector(map.axes.col(1)) + " " + vector(map.axes.col(2)) +
         "\nkinds: domain domain domain\nendian: little\nspace origin: " + vector(map.origin) +
         "\nkey:=value\n";
}

/// The header of a MetaImage file of uint16, little endian, up to CompressedData and ElementDataFile.
inline std::string meta_header(const LabelMap& map) {
  const Vec3 spacing = map.axes.colwise().norm().transpose();
  std::string matrix;
  for (int d = 0; d < 3; ++d) matrix.append(" ").append(numbers(map.axes.col(d) / spacing[d], " "));
  return "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nTransformMatrix "
         "=" +
         matrix + "\nOffset = " + numbers(map.origin, " ") +
         "\nCenterOfRotation = 0 0 0\nElementSpacing = " + numbers(spacing, " ") +
         "\nDimSize = " + sizes_of(map) + "\nElementType = MET_USHORT\n";
}

}  // namespace foramen::testing
