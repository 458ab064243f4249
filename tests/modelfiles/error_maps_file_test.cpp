#include "modelfiles/error_maps_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/evaluate/representation.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ErrorMapsFile : public ::testing::Test {
 protected:
  void SetUp() override {
    write_error_maps(file_, {{"a", {{0.5, 0.25, 0}, {0, 3}, {3}}}, {"b c", {{1, 2, 3}, {}, {}}}});
  }
  void expect_refused(const std::vector<std::string>& names, int landmarks, int triangles, const char* why) {
    try {
      read_error_maps(file_, names, landmarks, triangles);
      FAIL() << "not refused";
    } catch (const IoError& e) {
      EXPECT_THAT(e.what(), HasSubstr(why));
    }
  }
  const testing::TemporaryFolder folder_;
  const std::filesystem::path file_ = folder_.file("error_maps.h5");
};

TEST_F(ErrorMapsFile, ComesBackInTheOrderOfTheNames) {
  const auto maps = read_error_maps(file_, {"b c", "a"}, 3, 4);
  ASSERT_EQ(maps.size(), 2u);
  EXPECT_THAT(maps[0].landmark_mm, ElementsAre(1, 2, 3));
  EXPECT_THAT(maps[0].plain_flips, IsEmpty());
  EXPECT_THAT(maps[1].landmark_mm, ElementsAre(0.5, 0.25, 0));
  EXPECT_THAT(maps[1].plain_flips, ElementsAre(0, 3));
  EXPECT_THAT(maps[1].confirmed_flips, ElementsAre(3));
}

TEST_F(ErrorMapsFile, InSinglePrecisionIsWhatIsReadBack) {
  ErrorMap map{{}, {1, 2}, {2}};
  for (int i = 0; i < 100; ++i) map.landmark_mm.push_back(0.1 * i);
  write_error_maps(file_, {{"a", map}});
  const ErrorMap read = read_error_maps(file_, {"a"}, 100, 4).front(), rounded = in_single_precision(map);
  EXPECT_NE(rounded.landmark_mm, map.landmark_mm);
  EXPECT_EQ(rounded.landmark_mm, read.landmark_mm);
  EXPECT_EQ(rounded.plain_flips, read.plain_flips);
  EXPECT_EQ(rounded.confirmed_flips, read.confirmed_flips);
}

TEST_F(ErrorMapsFile, OfAnotherModelIsRefused) {
  expect_refused({"a", "x"}, 3, 4, "/shapes/x");
  expect_refused({"a"}, 5, 4, "3 numbers for 5 landmarks");
  expect_refused({"a"}, 3, 3, "none of 3 triangles");
}

}  // namespace
}  // namespace foramen
