#include "report/encoded_array.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAre;

template <class T>
EncodedArray array(const std::vector<T>& values, std::vector<std::size_t> shape) {
  return encoded(std::span<const T>(values), std::move(shape));
}

// By hand: 1.0f is 00 00 80 3f, -2.0f is 00 00 00 c0.
TEST(EncodedArray, HoldsTheBytesInLittleEndian) {
  const EncodedArray floats = array<float>({1.0f, -2.0f}, {2});
  EXPECT_EQ(floats.type, "f32");
  EXPECT_EQ(floats.base64, "AACAPwAAAMA=");
  EXPECT_EQ(array<std::uint16_t>({1, 0x0203}, {2}).base64, "AQADAg==");
  EXPECT_EQ(array<std::uint32_t>({0x01020304}, {1}).base64, "BAMCAQ==");
  EXPECT_EQ(array<std::int8_t>({-1, 0, 1}, {3}).base64, "/wAB");
  EXPECT_EQ(array<std::uint32_t>({}, {0}).base64, "");
}

TEST(EncodedArray, HasAPlaceForEveryNumber) {
  EXPECT_THAT(array<std::int8_t>({1, 2, 3, 4, 5, 6}, {2, 3}).shape, ElementsAre(2, 3));
  EXPECT_THROW(array<std::int8_t>({1, 2, 3, 4, 5}, {2, 3}), InternalError);
}

}  // namespace
}  // namespace foramen
