#include "inputs/subject_of.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/messages.hpp"

namespace foramen {
namespace {

TEST(SubjectOf, TakesTheFirstGroupOrTheWholeMatch) {
  EXPECT_EQ(subject_of("verse005_L1", "(.*)_L"), "verse005");
  EXPECT_EQ(subject_of("verse005_L1", "verse[0-9]+"), "verse005");
  EXPECT_EQ(subject_of("other", "verse[0-9]+"), "other");
  EXPECT_THAT(testing::refusal([] { subject_of("x", "("); }),
              AllOf(testing::says("'('"), testing::offers({{RemedyKind::subject_pattern}})));
}

}  // namespace
}  // namespace foramen
