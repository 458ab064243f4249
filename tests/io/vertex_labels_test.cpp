#include "io/vertex_labels.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "support/meshes.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAre;
using testing::TemporaryFolder;

std::string ply(const std::string& properties, const std::string& rows) {
  return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
         properties + "element face 1\nproperty list uchar int vertex_indices\nend_header\n" + rows +
         "3 0 1 2\n";
}

std::string vtp(const std::string& point_data) {
  return R"(<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData><Piece NumberOfPoints="3" NumberOfPolys="1"><PointData>)" +
         point_data +
         R"(</PointData><Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points><Polys><DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray><DataArray type="Int32" Name="offsets" format="ascii">3</DataArray></Polys></Piece></PolyData></VTKFile>)";
}

Message refused(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  const auto file = folder.file(name, bytes);
  const Message message = testing::refusal([&] { read_vertex_labels(file); });
  EXPECT_THAT(message, testing::says(file.string() + ": "));
  return message;
}

TEST(VertexLabels, AreWholeNumbersOneALine) {
  const TemporaryFolder folder;
  EXPECT_THAT(read_vertex_labels(folder.file("a.txt", "1\r\n 7 \n\n0")), ElementsAre(1, 7, 0));
  EXPECT_THAT(refused("a.txt", "1\n2.5\n"), testing::says("line 2: expected a whole number, found '2.5'"));
  EXPECT_THAT(refused("a.txt", "1 2\n"), testing::says("line 1"));
}

TEST(VertexLabels, AreTheNumbersOfPlyThatAreNoColoursOrNormals) {
  const TemporaryFolder folder;
  const std::string only =
      ply("property uchar red\nproperty float part\n", "0 0 0 9 1\n1 0 0 9 2\n0 1 0 9 1\n");
  EXPECT_THAT(read_vertex_labels(folder.file("only.ply", only)), ElementsAre(1, 2, 1));
  const std::string named = ply("property float depth\nproperty list uchar int ring\nproperty int Label\n",
                                "0 0 0 0.5 1 4 3\n1 0 0 0.5 2 4 4 5\n0 1 0 0.5 0 6\n");
  EXPECT_THAT(read_vertex_labels(folder.file("named.ply", named)), ElementsAre(3, 5, 6));
}

TEST(VertexLabels, OfBinaryPlyAreThoseWritten) {
  const TemporaryFolder folder;
  const TriangleSoup torus = testing::torus_soup(5, 4);
  VertexScalar label{"label", {}};
  std::vector<int> expected;
  for (int i = 0; i < 20; ++i) {
    label.values.push_back(i % 3);
    expected.push_back(i % 3);
  }
  write_ply(folder.file("a.ply"), torus, AnatomicalSpace::lps, std::vector{label});
  EXPECT_EQ(read_vertex_labels(folder.file("a.ply")), expected);
}

TEST(VertexLabels, AreScalarsOfVtp) {
  const TemporaryFolder folder;
  const std::string normals =
      R"(<DataArray type="Float32" Name="Normals" NumberOfComponents="3" format="ascii">0 0 1 0 0 1 0 0 1</DataArray>)";
  const std::string labels = R"(<DataArray type="Float64" Name="Segment" format="ascii">4 4 2</DataArray>)";
  EXPECT_THAT(read_vertex_labels(folder.file("a.vtp", vtp(normals + labels))), ElementsAre(4, 4, 2));
}

TEST(VertexLabels, AreScalarsOfLegacyVtk) {
  const TemporaryFolder folder;
  const std::string surface =
      "# vtk DataFile Version 3.0\n3D Slicer output. SPACE=LPS\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n"
      "0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\nCELL_DATA 1\nanything";
  const std::string cells = "CELL_DATA 1\nSCALARS label int\nLOOKUP_TABLE default\n9\n";
  const auto with_points = [&](const std::string& point_data) {
    return surface.substr(0, surface.find("CELL_DATA")) + "POINT_DATA 3\n" + point_data + cells;
  };
  EXPECT_THAT(
      read_vertex_labels(folder.file(
          "scalars.vtk", with_points("NORMALS Normals float\n0 0 1 0 0 1\n0 0 1\nSCALARS seg short 1\n"
                                     "LOOKUP_TABLE default\n4 5 4\n"))),
      ElementsAre(4, 5, 4));
  EXPECT_THAT(
      read_vertex_labels(folder.file(
          "field.vtk",
          with_points("FIELD FieldData 3\nNormals 3 3 float\n0 0 1 0 0 1 0 0 1\nname 1 3 string\na\nb\nc\n"
                      "Segment 1 3 double\n4 2 4\nMETADATA\nINFORMATION 0\n\n"))),
      ElementsAre(4, 2, 4));
  EXPECT_THAT(refused("cells.vtk", surface), testing::says("its vertices have no labels"));
  EXPECT_THAT(refused("short.vtk", with_points("SCALARS seg int\nLOOKUP_TABLE default\n4 5\n")),
              testing::says("expected a number in POINT_DATA"));
}

TEST(VertexLabels, FilesThatLeaveThemOpenAreRefused) {
  EXPECT_THAT(refused("a.ply", ply("property uchar red\n", "0 0 0 9\n1 0 0 9\n0 1 0 9\n")),
              testing::says("its vertices have no labels"));
  EXPECT_THAT(
      refused("a.ply", ply("property int one\nproperty int two\n", "0 0 0 1 2\n1 0 0 1 2\n0 1 0 1 2\n")),
      testing::says("the fields 'one', 'two'"));
  EXPECT_THAT(refused("a.ply", ply("property float label\n", "0 0 0 1\n1 0 0 1.5\n0 1 0 1\n")),
              testing::says("at vertex 1; labels are whole numbers"));
  EXPECT_THAT(refused("a.csv", "1\n"), testing::says("no file of labels"));
}

}  // namespace
}  // namespace foramen
