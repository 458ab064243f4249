#include "workflow/build_from.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/messages.hpp"
#include "workflow/read_family.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;

BuildOptions baseline() {
  BuildOptions options = testing::small();
  options.correspondence.method = Method::icp;
  options.landmarks.count = 200;
  return options;
}

TEST(BuildFrom, FewerThanThreeShapesAreRefusedWithWhatWasLeftOut) {
  Cohort cohort = testing::read(testing::family());
  cohort.shapes.resize(2);
  cohort.left_out.push_back({"bad", "bad.ply", "", Message("genus 3", {{RemedyKind::repair}})});
  try {
    build_from(std::move(cohort), testing::small(), RunContext(1));
    FAIL() << "not refused";
  } catch (const InvalidInput& e) {
    EXPECT_THAT(e.what(), HasSubstr("at least 3"));
    EXPECT_THAT(e.what(), HasSubstr("bad.ply: genus 3"));
    EXPECT_THAT(message_of(e), testing::offers({{RemedyKind::repair}}));
  }
}

TEST(BuildFrom, TheReferenceMayBeNamedByItsFile) {
  BuildOptions options = baseline();
  options.correspondence.reference = "s2.ply";
  const BuildRecord record = testing::family_build(options);
  EXPECT_EQ(record.inputs[record.built.registration.reference].stem, "s2");
}

TEST(BuildFrom, InputsAreThoseOfTheModelInItsOrder) {
  const BuildRecord record = testing::family_build(baseline());
  ASSERT_EQ(record.inputs.size(), record.built.landmarks.names.size());
  for (std::size_t i = 0; i < record.inputs.size(); ++i)
    EXPECT_EQ(record.inputs[i].stem, record.built.landmarks.names[i]);
}

}  // namespace
}  // namespace foramen
