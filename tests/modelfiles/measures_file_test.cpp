#include "modelfiles/measures_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

TEST(MeasuresFile, HoldsPointsDistancesAndRegions) {
  const testing::TemporaryFolder folder;
  const MeasureDefinitions read = read_measures(folder.file("m.json", R"({
    "points": {"tip": [1.5, 40, -3], "front": 17},
    "distances": {"length": ["tip", "front"]},
    "regions": {"facet": {"centre": "tip", "radius_mm": 6}, "rim": {"landmarks": [3, 4, 5]}}})"));
  ASSERT_EQ(read.points.size(), 2u);
  EXPECT_EQ(read.points[0].name, "tip");
  EXPECT_EQ(std::get<Vec3>(read.points[0].place), Vec3(1.5, 40, -3));
  EXPECT_EQ(std::get<int>(read.points[1].place), 17);
  ASSERT_EQ(read.distances.size(), 1u);
  EXPECT_EQ(read.distances[0].from, "tip");
  EXPECT_EQ(read.distances[0].to, "front");
  ASSERT_EQ(read.regions.size(), 2u);
  EXPECT_EQ(std::get<NamedRegion::Ball>(read.regions[0].extent).radius_mm, 6);
  EXPECT_EQ(std::get<std::vector<int>>(read.regions[1].extent), (std::vector<int>{3, 4, 5}));
}

TEST(MeasuresFile, NamesFileAndPartThatAreWrong) {
  const testing::TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& said) {
    try {
      read_measures(folder.file("m.json", text));
      FAIL() << text;
    } catch (const IoError& e) {
      EXPECT_THAT(e.what(), ::testing::HasSubstr("m.json"));
      EXPECT_THAT(e.what(), ::testing::HasSubstr(said));
    }
  };
  refused("{", "no JSON");
  refused("[]", "the file");
  refused(R"({"point": {"a": 1}})", "\"point\"");
  refused(R"({"points": [1]})", "\"points\"");
  refused(R"({"points": {"a": [1, 2]}})", "\"a\"");
  refused(R"({"points": {"a": 1.5}})", "\"a\"");
  refused(R"({"points": {"a": 99999999999}})", "\"a\"");
  refused(R"({"distances": {"d": ["a"]}})", "\"d\"");
  refused(R"({"regions": {"r": {"centre": "a"}}})", "\"r\"");
  refused(R"({"regions": {"r": {"landmarks": [1.5]}}})", "\"r\"");
  EXPECT_THROW(read_measures(folder.path() / "none.json"), IoError);
  EXPECT_THROW(parse_measures(R"({"points": [1]})"), InvalidInput) << "without a file";
}

}  // namespace
}  // namespace foramen
