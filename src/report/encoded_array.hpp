#pragma once
/// \file
/// Numbers inside a page: typed arrays as Base64.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foramen {

struct EncodedArray {
  std::string type;                ///< f32, i8, u16 or u32
  std::vector<std::size_t> shape;  ///< the last index runs fastest
  std::string base64;              ///< of the numbers, little endian
};

/// T is float, std::int8_t, std::uint16_t or std::uint32_t. \pre as many values as the shape has places
template <class T>
EncodedArray encoded(std::span<const T> values, std::vector<std::size_t> shape);

}  // namespace foramen
