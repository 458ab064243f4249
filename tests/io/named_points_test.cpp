#include "io/named_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "foramen/core/error.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::bytes_of;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

std::vector<NamedPoints> example() {
  return {{"L1_a", {{0.1, -2, 1e-7}, {1.0 / 3, 4, 5}}}, {"L1 b", {{7, 8, 9}, {-1e10, 0, 2}}}};
}

void expect_same(const std::vector<NamedPoints>& a, const std::vector<NamedPoints>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].name, b[i].name);
    EXPECT_EQ(a[i].points, b[i].points);
  }
}

template <class Read>
std::string refusal(const Read& read) {
  try {
    read();
  } catch (const Error& e) {
    return e.what();
  }
  return "not refused";
}

std::string refused_tps(std::string_view bytes) {
  const TemporaryFolder folder;
  return refusal([&] { read_tps(folder.file("a.tps", bytes)); });
}

TEST(Tps, RoundTrip) {
  const TemporaryFolder folder;
  write_tps(folder.file("a.tps"), example());
  EXPECT_EQ(bytes_of(folder.file("a.tps")).substr(0, 18), "LM3=2\n0.1 -2 1e-07");
  expect_same(read_tps(folder.file("a.tps")).specimens, example());
}

TEST(Tps, FilesOfOthers) {
  const TemporaryFolder folder;
  const auto file =
      folder.file("a.tps",
                  "COMMENT=of a clinic\r\nlm3=1\r\n 1\t2  3 \r\nIMAGE=first.jpg\r\nSCALE=0.5\r\n\r\n"
                  "LM3=1\r\n4 5 6\r\nSCALE=2\r\n");
  expect_same(read_tps(file).specimens, {{"first", {{0.5, 1, 1.5}}}, {"specimen2", {{8, 10, 12}}}});
}

TEST(Tps, SpecimensWithMissingPointsAndCurvesAreLeftOut) {
  const TemporaryFolder folder;
  const auto file =
      read_tps(folder.file("a.tps",
                           "LM=2\n1 2 3\n4 5 6\nID=a\nLM3=2\nNA NA NA\n4 5 6\nID=b\nLM3=2\n1 2 3\n"
                           "7 8 NaN\nID=c\nLM=0\nIMAGE=d.jpg\nLM3=2\n7 8 9\n-1 -1 -1\nCURVES=2\n"
                           "POINTS=1\n9 9 9\nPOINTS=2\n9 9\n9 9\nID=e\n"));
  expect_same(file.specimens, {{"a", {{1, 2, 3}, {4, 5, 6}}}, {"e", {{7, 8, 9}, {-1, -1, -1}}}});
  EXPECT_EQ(file.notes,
            (std::vector<std::string>{"3 of 5 specimens have missing points and were left out: b, c, d",
                                      "2 curves were left out"}));
}

TEST(Tps, WhatIsNoneIsRefused) {
  EXPECT_THAT(refused_tps("LM=2\n1 2\n3 4\n"), HasSubstr("two-dimensional"));
  EXPECT_THAT(refused_tps("LM3=2\n1.00000 2.00000 3.00000\n"), HasSubstr("ends within"));
  EXPECT_THAT(refused_tps("LM3=1\n1 NA 3\nID=a\n"), HasSubstr("points are missing in every specimen (a)"));
  EXPECT_THAT(refused_tps("LM3=1\n1 NB 3\n"), HasSubstr("line 2: expected three numbers"));
  EXPECT_THAT(refused_tps("LM3=1\n1 2 3 4\n"), HasSubstr("line 2"));
  EXPECT_THAT(refused_tps("LM3=1\n1 2 3\n4 5 6\n"), HasSubstr("line 3"));
  EXPECT_THAT(refused_tps("LM3=900000000000\n1 2 3\n"), HasSubstr("no number of points"));
  EXPECT_THAT(refused_tps("LM3=1\n1 2 3\nID=a\nLM3=2\n1 2 3\n4 5 6\nID=b\n"), HasSubstr("'b' has 2 points"));
  EXPECT_THAT(refused_tps("LM3=1\n1 2 3\nID=a\nLM3=1\n1 2 3\nID=a\n"), HasSubstr("the name 'a'"));
  EXPECT_THAT(refused_tps("LM3=1\n1 2 3\nSCALE=2\nLM3=1\n1 2 3\nID=b\n"), HasSubstr("'b' has no SCALE="));
  EXPECT_THAT(refused_tps("LM3=1\n1 2 3\nCURVES=1\nPOINTS=2\n1 2 3\n"), HasSubstr("ends within"));
  EXPECT_THAT(refused_tps("hello\n"), HasSubstr("KEY=value"));
}

TEST(Tps, NamesThatReadersDropAreRefused) {
  const TemporaryFolder folder;
  for (const char* name : {"a=b", "Chain 1", "scaled", "", "two\nlines"}) {
    std::vector<NamedPoints> points = example();
    points[1].name = name;
    EXPECT_THROW(write_tps(folder.file("a.tps"), points), InvalidInput) << name;
  }
  EXPECT_EQ(folder.size(), 0);
}

TEST(LandmarkTable, RoundTrip) {
  const TemporaryFolder folder;
  write_landmark_table(folder.file("a.csv"), example());
  EXPECT_THAT(bytes_of(folder.file("a.csv")), HasSubstr("shape,landmark,x,y,z\nL1_a,0,0.1,-2,1e-07\n"));
  expect_same(read_landmark_table(folder.file("a.csv")), example());
}

TEST(LandmarkTable, WhatIsNoneIsRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](std::string_view bytes) {
    return refusal([&] { read_landmark_table(folder.file("a.csv", bytes)); });
  };
  EXPECT_THAT(refused("shape,x,y,z\na,1,2,3\n"), HasSubstr("no column 'landmark'"));
  EXPECT_THAT(refused("shape,landmark,x,y,z\na,1,1,2,3\n"), HasSubstr("row 1: expected landmark 0"));
  EXPECT_THAT(refused("shape,landmark,x,y,z\na,0,1,2,nan\n"), HasSubstr("not finite"));
  EXPECT_THAT(refused("shape,landmark,x,y,z\na,0,1,2,q\n"), HasSubstr("'q'"));
  EXPECT_THAT(refused("shape,landmark,x,y,z\n"), HasSubstr("no points"));
  EXPECT_THAT(refused("shape,landmark,x,y,z\na,0,1,2,3\nb,0,1,2,3\nb,1,1,2,3\n"), HasSubstr("'b' has 2"));
  std::vector<NamedPoints> points = example();
  points[0].points[0].x() = std::numeric_limits<double>::infinity();
  EXPECT_THROW(write_landmark_table(folder.file("b.csv"), points), InvalidInput);
}

}  // namespace
}  // namespace foramen
