#include "inputs/read_marks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "inputs/shape_of_file.hpp"
#include "support/label_maps.hpp"
#include "support/meshes.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using testing::TemporaryFolder;

MarkedShapes two_shapes() { return {{"p1_T1", "p1_T10"}, {AnatomicalSpace::lps, AnatomicalSpace::ras}}; }

std::string curve(const std::string& labels) {
  return R"({"markups": [{"type": "Curve", "coordinateSystem": "LPS", "controlPoints": [
    {"label": ")" +
         labels + R"(1", "position": [1, 2, 3]}, {"label": ")" + labels + R"(2", "position": [4, 5, 6]}]}]})";
}

TEST(ShapeOfFile, IsNamedByTheFileOrItsFolders) {
  const std::vector<std::string> names{"p1_T1", "p1_T10", "p2_T1"};
  const auto of = [&](const fs::path& path) -> std::pair<int, std::string> {
    const auto found = shape_of_file(path, path.stem().string(), names);
    return found ? std::pair(found->shape, found->rest) : std::pair(-1, "");
  };
  EXPECT_EQ(of("/d/p1_T10.csv"), std::pair(1, std::string("")));
  EXPECT_EQ(of("/d/p1_T1_rim.csv"), std::pair(0, std::string("rim")));
  EXPECT_EQ(of("/d/p1_T100.csv"), std::pair(-1, std::string("")));
  EXPECT_EQ(of("/d/p2/T1.csv"), std::pair(2, std::string("")));
  EXPECT_EQ(of("/d/p2/more/T1-rim.csv"), std::pair(2, std::string("rim")));
  EXPECT_EQ(of("/d/p1_T10/rim.csv"), std::pair(1, std::string("rim")));
  EXPECT_EQ(of("/d/p2/T1/rim.csv"), std::pair(2, std::string("rim")));
  EXPECT_EQ(of("/d/other.csv"), std::pair(-1, std::string("")));
}

TEST(ReadMarks, TableOfAllShapesAndFilesOfOne) {
  const TemporaryFolder folder;
  fs::create_directories(folder.file("p1_T10"));
  folder.file("all.csv", "shape,landmark,x,y,z\np1_T1,tip,1,2,3\np1_T10.ply,tip,4,5,6\nelse,tip,0,0,0\n");
  folder.file("p1_T10/front rim.mrk.json", curve(""));
  folder.file("p1_T1_x.mrk.json", curve("rim-"));
  const ReadMarks read = read_marks({folder.path()}, two_shapes(), {});
  ASSERT_EQ(read.marks.size(), 2u);
  ASSERT_EQ(read.marks[0].size(), 2u);
  EXPECT_EQ(read.marks[0][0].name, "tip");
  EXPECT_EQ(read.marks[0][1].name, "rim");
  EXPECT_EQ(read.marks[0][1].points[0], Vec3(1, 2, 3));
  ASSERT_EQ(read.marks[1].size(), 2u);
  EXPECT_EQ(read.marks[1][0].points[0], Vec3(4, 5, 6));  // a table has the coordinates of the surface
  EXPECT_EQ(read.marks[1][1].name, "front rim");
  EXPECT_EQ(read.marks[1][1].points[0], Vec3(-1, -2, 3));  // from LPS to the RAS of that surface
  EXPECT_THAT(read.notes,
              ElementsAre(testing::says("1 shapes or files that are not among the shapes here: else")));
}

TEST(ReadMarks, CoordinatesAreMadeMillimetres) {
  const TemporaryFolder folder;
  const auto file = folder.file("p1_T1.csv", "landmark,x,y,z\ntip,1,2,3\n");
  EXPECT_EQ(read_marks({file}, two_shapes(), {LengthUnit::centimetre}).marks[0][0].points[0],
            Vec3(10, 20, 30));
}

TEST(ReadMarks, WhatCannotBeMatchedIsRefused) {
  const TemporaryFolder folder;
  const auto refused = [&](const fs::path& path) {
    return testing::refusal([&] { read_marks({path}, two_shapes(), {}); });
  };
  EXPECT_THAT(refused(folder.file("none.csv")), testing::says("no such file or folder"));
  fs::create_directories(folder.file("empty"));
  EXPECT_THAT(refused(folder.file("empty")), testing::says("the folder holds no marks"));
  EXPECT_THAT(refused(folder.file("T3.csv", "landmark,x,y,z\ntip,1,2,3\n")),
              testing::says("of no shape here (found T3; the shapes are p1_T1, p1_T10)"));
  EXPECT_THAT(refused(folder.file("p1_T1.mrk.json", curve(""))), testing::says("a curve has no name"));
}

TEST(ReadRegions, ALabelMapIsLaidOverTheSurface) {
  const TemporaryFolder folder;
  const LabelMap map = testing::labelled_lattice({80, 80, 80}, Mat3::Identity(),
                                                 [](const Vec3& p) { return p.x() < 0 ? 3 : 8; });
  folder.file("p1_T10.seg.nrrd",
              testing::nrrd_header(map) + "encoding: raw\n\n" + testing::voxel_bytes<std::uint16_t>(map));
  MarkedShapes shapes = two_shapes();
  shapes.surfaces.assign(2, build_mesh(testing::torus_soup(24, 12)));
  const ReadRegions read = read_regions({folder.path()}, shapes);
  EXPECT_TRUE(read.regions[0].names.empty());
  EXPECT_THAT(read.regions[1].names, ::testing::UnorderedElementsAre("3", "8"));
  EXPECT_EQ(read.regions[1].of_vertex.size(), 24u * 12u);
}

TEST(ReadRegions, LabelsAreNamesAndZeroIsNone) {
  const TemporaryFolder folder;
  folder.file("p1_T1.txt", "7\n0\n2\n7\n");
  folder.file("readme.txt", "1\n");
  const ReadRegions read = read_regions({folder.path()}, two_shapes());
  EXPECT_THAT(read.regions[0].names, ElementsAre("7", "2"));
  EXPECT_THAT(read.regions[0].of_vertex, ElementsAre(0, -1, 1, 0));
  EXPECT_TRUE(read.regions[1].names.empty());
  EXPECT_THAT(read.notes, ElementsAre(testing::says("readme")));
  folder.file("p1_T1_again.txt", "1\n");
  EXPECT_THAT(testing::refusal([&] { read_regions({folder.path()}, two_shapes()); }),
              testing::says("are both labels of p1_T1"));
}

}  // namespace
}  // namespace foramen
