#include "report/encoded_array.hpp"

#include <bit>
#include <concepts>
#include <functional>
#include <numeric>
#include <string_view>

#include "foramen/core/error.hpp"
#include "report/html_text.hpp"

namespace foramen {
namespace {

static_assert(std::endian::native == std::endian::little, "pages hold numbers in little endian");

template <class T>
constexpr const char* type_name() {
  if constexpr (std::same_as<T, float>) return "f32";
  if constexpr (std::same_as<T, std::int8_t>) return "i8";
  if constexpr (std::same_as<T, std::uint16_t>) return "u16";
  if constexpr (std::same_as<T, std::uint32_t>) return "u32";
}

}  // namespace

template <class T>
EncodedArray encoded(std::span<const T> values, std::vector<std::size_t> shape) {
  FORAMEN_ASSERT(values.size() ==
                 std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>()));
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): the bytes of the numbers are what is wanted
  const std::string_view bytes(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  return {type_name<T>(), std::move(shape), base64(bytes)};
}

template EncodedArray encoded(std::span<const float>, std::vector<std::size_t>);
template EncodedArray encoded(std::span<const std::int8_t>, std::vector<std::size_t>);
template EncodedArray encoded(std::span<const std::uint16_t>, std::vector<std::size_t>);
template EncodedArray encoded(std::span<const std::uint32_t>, std::vector<std::size_t>);

}  // namespace foramen
