#pragma once
/// \file
/// Private to io: the header of a PLY file, from "ply" to "end_header".

#include <optional>
#include <string>
#include <vector>

#include "io/file_bytes.hpp"

namespace foramen::io_detail {

enum class PlyScalar { i8, u8, i16, u16, i32, u32, f32, f64 };
std::size_t byte_size(PlyScalar type);
inline bool is_integer(PlyScalar type) { return type != PlyScalar::f32 && type != PlyScalar::f64; }

struct PlyProperty {
  std::string name;
  PlyScalar type = PlyScalar::f32;
  std::optional<PlyScalar> count_type;  ///< set if the property is a list of `type`
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { ascii, binary_little_endian, binary_big_endian };

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::optional<AnatomicalSpace> space;
};

/// Leaves `lines` at the first byte of the body.
PlyHeader parse_ply_header(const Source& source, LineCursor& lines);

}  // namespace foramen::io_detail
