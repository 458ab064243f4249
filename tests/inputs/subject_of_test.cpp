#include "inputs/subject_of.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"

namespace foramen {
namespace {

TEST(SubjectOf, TakesTheFirstGroupOrTheWholeMatch) {
  EXPECT_EQ(subject_of("verse005_L1", "(.*)_L"), "verse005");
  EXPECT_EQ(subject_of("verse005_L1", "verse[0-9]+"), "verse005");
  EXPECT_EQ(subject_of("other", "verse[0-9]+"), "other");
  EXPECT_THROW(subject_of("x", "("), InvalidInput);
}

}  // namespace
}  // namespace foramen
