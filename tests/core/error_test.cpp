#include "foramen/core/error.hpp"

#include <string>
#include <type_traits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foramen {
namespace {

// Code that catches Error handles mistakes of the user. It must catch neither defects of foramen nor a
// request to stop.
static_assert(std::is_base_of_v<Error, IoError> && std::is_base_of_v<Error, InvalidInput> &&
              std::is_base_of_v<InvalidInput, TopologyError> && std::is_base_of_v<Error, ConvergenceError> &&
              std::is_base_of_v<Error, Cancelled>);
static_assert(!std::is_base_of_v<Error, InternalError> && !std::is_base_of_v<InvalidInput, Cancelled> &&
              !std::is_base_of_v<InvalidInput, ConvergenceError>);

TEST(Assert, ThrowsWhatDoesNotHoldAndWhere) {
  const int three = 3;
  EXPECT_NO_THROW(FORAMEN_ASSERT(three == 3));
  try {
    FORAMEN_ASSERT(three == 4);
    FAIL() << "nothing was thrown";
  } catch (const InternalError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("three == 4"));
    EXPECT_THAT(e.what(), ::testing::HasSubstr("at error_test.cpp:"));
  }
}

}  // namespace
}  // namespace foramen
