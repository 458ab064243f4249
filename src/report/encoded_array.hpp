#pragma once
/// \file
/// Typed arrays as Base64, for numbers inside a page.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace foramen {

struct EncodedArray {
  std::string type;                ///< f32, i8, u16 or u32
  std::vector<std::size_t> shape;  ///< the last index runs fastest
  std::string base64;              ///< the numbers, in little-endian order
};

/// Encodes values of type float, std::int8_t, std::uint16_t or std::uint32_t. \pre the number of values is
/// the product of the shape
template <class T>
EncodedArray encoded(std::span<const T> values, std::vector<std::size_t> shape);

}  // namespace foramen
