#include "io/mark_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::TemporaryFolder;

const std::string slicer =
    R"({"@schema": "https://raw.githubusercontent.com/slicer/slicer/master/markups-schema-v1.0.3.json#",
 "markups": [
 {"type": "Fiducial", "coordinateSystem": "LPS", "coordinateUnits": "mm", "controlPoints": [
   {"id": "1", "label": "SSL", "position": [1, 2, 3], "positionStatus": "defined"},
   {"id": "2", "label": "later", "position": [0, 0, 0], "positionStatus": "undefined"}]},
 {"type": "Curve", "coordinateSystem": "LPS", "coordinateUnits": ["mm", "mm", "mm"], "controlPoints": [
   {"label": "rim-1", "position": [1, 0, 0]}, {"label": "rim-2", "position": [2, 0, 0.5]}]},
 {"type": "ClosedCurve", "coordinateSystem": "LPS", "name": "facet", "controlPoints": [
   {"label": "a", "position": [1, 0, 0]}, {"label": "b", "position": [2, 0, 0]}, {"label": "c", "position": [2, 1, 0]}]},
 {"type": "Line", "coordinateSystem": "LPS", "controlPoints": [
   {"label": "p", "position": [1, 0, 0]}, {"label": "q", "position": [2, 0, 0]}]}]})";

Message refused(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  const auto file = folder.file(name, bytes);
  const Message message = testing::refusal([&] { read_mark_file(file); });
  EXPECT_THAT(message, testing::says(file.string() + ": "));
  EXPECT_THAT(message, testing::says("; "));
  return message;
}

std::string with(const std::string& text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return std::string(text).replace(at, from.size(), to);
}

TEST(MarkFile, SlicerMarkupsArePointsAndCurves) {
  const TemporaryFolder folder;
  const MarkFile file = read_mark_file(folder.file("a.mrk.json", slicer));
  EXPECT_EQ(file.space, AnatomicalSpace::lps);
  ASSERT_EQ(file.shapes.size(), 1u);
  EXPECT_EQ(file.shapes[0].shape, "");
  const MarksOfShape& marks = file.shapes[0].marks;
  ASSERT_EQ(marks.size(), 4u);
  EXPECT_EQ(marks[0].name, "SSL");
  EXPECT_EQ(marks[0].kind, MarkKind::point);
  EXPECT_EQ(marks[0].points, (std::vector<Vec3>{{1, 2, 3}}));
  EXPECT_EQ(marks[1].name, "rim");
  EXPECT_EQ(marks[1].kind, MarkKind::open_curve);
  EXPECT_EQ(marks[1].points, (std::vector<Vec3>{{1, 0, 0}, {2, 0, 0.5}}));
  EXPECT_EQ(marks[2].name, "facet");
  EXPECT_EQ(marks[2].kind, MarkKind::closed_curve);
  EXPECT_EQ(marks[3].name, "");
  EXPECT_EQ(marks[3].kind, MarkKind::open_curve);
}

TEST(MarkFile, SlicerMarkupsThatCannotBeUsedAreRefused) {
  EXPECT_THAT(refused("a.json", with(slicer, "\"Fiducial\"", "\"Plane\"")), testing::says("type 'Plane'"));
  EXPECT_THAT(refused("a.json", with(slicer, "\"LPS\"", "\"IJK\"")), testing::says("neither LPS nor RAS"));
  EXPECT_THAT(refused("a.json", with(slicer, "\"LPS\"", "\"RAS\"")),
              testing::says("different coordinate systems"));
  EXPECT_THAT(refused("a.json", with(slicer, "\"mm\"", "\"m\"")), testing::says("coordinates in \"m\""));
  EXPECT_THAT(refused("a.json", with(slicer, "[1, 2, 3]", "[1, 2]")),
              testing::says("markup 1, control point 1"));
  EXPECT_THAT(refused("a.json", with(slicer, "\"SSL\"", "\"\"")), testing::says("without a label"));
  EXPECT_THAT(refused("a.json", R"({"points": []})"), testing::says("neither a list of landmarks"));
  EXPECT_THAT(refused("a.json", R"({"markups": []})"), testing::says("no placed points"));
}

TEST(MarkFile, FcsvNamesItsSpaceOrIsOld) {
  const TemporaryFolder folder;
  const std::string rows =
      "# columns = id,x,y,z,ow,ox,oy,oz,vis,sel,lock,label,desc,associatedNodeID\n"
      "0,1.5,-2,3,0,0,0,1,1,1,0,SSL,,\n1,4,5,6,0,0,0,1,1,1,0,ITL_L,tip,node\n";
  const MarkFile lps = read_mark_file(
      folder.file("new.fcsv", "# Markups fiducial file version = 4.11\n# CoordinateSystem = LPS\n" + rows));
  EXPECT_EQ(lps.space, AnatomicalSpace::lps);
  const MarksOfShape& marks = lps.shapes.at(0).marks;
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[0].name, "SSL");
  EXPECT_EQ(marks[0].points.at(0), Vec3(1.5, -2, 3));
  EXPECT_EQ(marks[1].name, "ITL_L");
  EXPECT_EQ(read_mark_file(folder.file("numbered.fcsv", "# CoordinateSystem = 1\r\n" + rows)).space,
            AnatomicalSpace::lps);
  EXPECT_EQ(read_mark_file(folder.file("old.fcsv", rows)).space, AnatomicalSpace::ras);
  EXPECT_THAT(refused("a.fcsv", with(rows, "-2", "x")), testing::says("line 2: expected a coordinate"));
  EXPECT_THAT(refused("a.fcsv", with(rows, "label", "name")), testing::says("no column label"));
  EXPECT_THAT(refused("a.fcsv", "1,2,3\n"), testing::says("line 1 has 3 cells"));
}

TEST(MarkFile, ScalismoLandmarksArePoints) {
  const TemporaryFolder folder;
  const MarkFile file =
      read_mark_file(folder.file("a.json", R"([{"id": "tip", "coordinates": [1, 2, 3], "extensions": {}}])"));
  EXPECT_FALSE(file.space);
  EXPECT_EQ(file.shapes.at(0).marks.at(0).name, "tip");
  EXPECT_EQ(file.shapes.at(0).marks.at(0).points.at(0), Vec3(1, 2, 3));
}

TEST(MarkFile, TableOfManyShapesHasItsPointsInOrderOfTheIndex) {
  const TemporaryFolder folder;
  const MarkFile file = read_mark_file(folder.file("a.csv",
                                                   "shape,landmark,kind,index,x,y,z\nA,rim,open,1,1,0,0\n"
                                                   "B,tip,point,0,7,8,9\nA,rim,open,0,0,0,0.5\n"));
  EXPECT_FALSE(file.space);
  ASSERT_EQ(file.shapes.size(), 2u);
  EXPECT_EQ(file.shapes[0].shape, "A");
  EXPECT_EQ(file.shapes[0].marks.at(0).kind, MarkKind::open_curve);
  EXPECT_EQ(file.shapes[0].marks.at(0).points, (std::vector<Vec3>{{0, 0, 0.5}, {1, 0, 0}}));
  EXPECT_EQ(file.shapes[1].marks.at(0).points, (std::vector<Vec3>{{7, 8, 9}}));
}

TEST(MarkFile, TableOfOneShapeNeedsItsPointsAlone) {
  const TemporaryFolder folder;
  const MarkFile file = read_mark_file(folder.file("a.csv", "x,y,z,landmark\n1,2,3,tip\n4,5,6,root\n"));
  ASSERT_EQ(file.shapes.size(), 1u);
  EXPECT_EQ(file.shapes[0].shape, "");
  EXPECT_EQ(file.shapes[0].marks.size(), 2u);
  EXPECT_EQ(file.shapes[0].marks[1].kind, MarkKind::point);
}

TEST(MarkFile, TablesWithMistakesAreRefused) {
  EXPECT_THAT(refused("a.csv", "landmark,x,y\na,1,2\n"), testing::says("no column 'z'"));
  EXPECT_THAT(refused("a.csv", "landmark,x,y,z\n"), testing::says("no rows"));
  EXPECT_THAT(refused("a.csv", "landmark,x,y,z\na,1,2,z\n"), testing::says("row 1: expected a number"));
  EXPECT_THAT(refused("a.csv", "landmark,x,y,z\n,1,2,3\n"), testing::says("no landmark"));
  const std::string curve = "landmark,kind,index,x,y,z\na,open,0,1,2,3\na,open,1,1,2,4\n";
  EXPECT_THAT(refused("a.csv", with(curve, "a,open,1", "a,closed,1")), testing::says("row 2: the mark"));
  EXPECT_THAT(refused("a.csv", with(curve, "a,open,1", "a,open,0")),
              testing::says("two points of the index 0"));
  EXPECT_THAT(refused("a.csv", with(curve, "a,open,1", "a,open,x")), testing::says("expected an index"));
  EXPECT_THAT(refused("a.csv", with(curve, "a,open,0", "a,ring,0")), testing::says("point, open or closed"));
}

TEST(MarkFile, StemsLeaveOutBothExtensionsOfSlicer) {
  EXPECT_EQ(mark_stem("x/L1_07.mrk.json"), "L1_07");
  EXPECT_EQ(mark_stem("L1.07.csv"), "L1.07");
  EXPECT_TRUE(is_mark_file("a.FCSV"));
  EXPECT_FALSE(is_mark_file("a.txt"));
}

}  // namespace
}  // namespace foramen
