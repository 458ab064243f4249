// Surfaces as programs of all kinds write them: each must be read as the plain file is, with at most one
// note.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <lz4.h>
#include <lzma.h>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/topology/inspect_mesh.hpp"
#include "io/mesh_bytes.hpp"
#include "io/triangulate_polygon.hpp"
#include "support/label_maps.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using testing::raw;
using testing::TemporaryFolder;
using testing::tetrahedron;
using Triangles = std::vector<std::array<int, 3>>;

// The text of the only note; empty if there is none.
std::string note_of(const MeshFile& file) {
  EXPECT_LE(file.notes.size(), 1u);
  return file.notes.empty() ? "" : file.notes[0].text;
}

MeshFile read(const std::string& name, const std::string& bytes) {
  const TemporaryFolder folder;
  return read_mesh(folder.file(name, bytes));
}

void expect_tetrahedron(const MeshFile& file, const std::string& note = "") {
  EXPECT_EQ(file.soup.points, tetrahedron().points);
  EXPECT_EQ(file.soup.triangles, tetrahedron().triangles);
  EXPECT_EQ(note_of(file), note);
}

const std::string points = "0 0 0\n1 0 0\n0 2 0\n0 0 3\n", faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
const std::string text_ply = "ply\nformat ascii 1.0\nelement vertex 4\n" + xyz +
                             "element face 4\nproperty list uchar int vertex_indices\nend_header\n" + points +
                             faces;

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string binary_ply() {
  const TemporaryFolder folder;
  write_ply(folder.file("a.ply"), tetrahedron());
  return testing::bytes_of(folder.file("a.ply"));
}

TEST(PlyVariants, CommentsBeforeFormatAndObjInfoAnywhere) {
  expect_tetrahedron(read("a.ply", changed(text_ply, "format", "comment by meshio\nobj_info x\nformat")));
  expect_tetrahedron(read("a.ply", changed(text_ply, "property float y", "obj_info x\n\nproperty float y")));
  EXPECT_EQ(read("a.ply", changed(text_ply, "format", "comment SPACE=RAS\nformat")).space,
            AnatomicalSpace::ras);
  expect_tetrahedron(read("a.ply", "\xef\xbb\xbf" + text_ply));
}

TEST(PlyVariants, BytesAfterTheLastElement) {
  expect_tetrahedron(read("a.ply", binary_ply() + "\n"));
  expect_tetrahedron(read("a.ply", binary_ply() + "\r\n"));
  expect_tetrahedron(read("a.ply", binary_ply() + std::string(5, '\0')),
                     "5 bytes after the surface passed over");
  expect_tetrahedron(read("a.ply", text_ply + "\n \nrest"), "4 bytes after the surface passed over");
}

TEST(PlyVariants, PolygonsKeepTheirPlaceAmongTheTriangles) {
  const std::string square = "ply\nformat ascii 1.0\nelement vertex 5\n" + xyz +
                             "element face 4\nproperty list uchar int vertex_index\nend_header\n"
                             "0 0 0\n2 0 0\n2 1 0\n0 1 0\n1 1 4\n3 0 1 4\n4 0 1 2 3\n2 0 1\n3 1 2 4\n";
  const MeshFile file = read("a.ply", square);
  EXPECT_EQ(file.soup.triangles, (Triangles{{0, 1, 4}, {0, 1, 2}, {0, 2, 3}, {1, 2, 4}}));
  EXPECT_EQ(note_of(file), "1 polygon cut into triangles; 1 loose cell (points, lines) passed over");
}

TEST(PlyVariants, StripsInOneListAndSkippedElements) {
  const std::string strips = "ply\nformat ascii 1.0\nelement vertex 5\n" + xyz +
                             "element tristrips 1\nproperty list int int vertex_indices\n"
                             "element edge 1\nproperty int a\nproperty list uchar float w\nend_header\n"
                             "0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n9 0 1 2 3 -1 2 3 4 4\n7 2 1.5 2\n";
  const MeshFile file = read("a.ply", strips);
  EXPECT_EQ(file.soup.triangles, (Triangles{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
  EXPECT_EQ(note_of(file), "2 triangle strips taken apart");
}

TEST(StlVariants, ColoursCountOfZeroAndBytesAtTheEnd) {
  const TriangleSoup expected = testing::in_order_of_use(tetrahedron());
  const std::string plain = testing::binary_stl(tetrahedron(), "COLOR=\x10\x20\x30\xff,MATERIAL=\1\2\3\4");
  std::string coloured = plain, uncounted = plain;
  for (std::size_t facet = 0; facet < 4; ++facet) coloured.replace(84 + 50 * facet + 48, 2, "\x1f\xfc");
  uncounted.replace(80, 4, std::string(4, '\0'));
  for (const std::string& bytes : {coloured, uncounted}) {
    const MeshFile file = read("a.stl", bytes);
    EXPECT_EQ(file.soup.triangles, expected.triangles);
    EXPECT_EQ(note_of(file), "");
  }
  EXPECT_EQ(note_of(read("a.stl", plain + "tail")), "4 bytes after the surface passed over");
  EXPECT_EQ(note_of(read("a.stl", uncounted + "tail")), "4 bytes after the surface passed over");
  const std::string text = testing::ascii_stl(tetrahedron());
  EXPECT_EQ(read("a.stl", "\xef\xbb\xbf" + text).soup.triangles, expected.triangles);
  EXPECT_THAT(note_of(read("a.stl", text + "\nend of file\n")), HasSubstr("passed over"));
}

TEST(ObjVariants, ContinuedLinesPolygonsLinesAndMaterials) {
  const std::string v = "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\n";
  expect_tetrahedron(read(
      "a.obj",
      "\xef\xbb\xbf# x\n" + v + "usemtl bone\nf 1 \\\n3 \\\n2\nf 1 2 4\nf 2 3 \\\r\n4\nf -2 -4 -1 \\\n"));
  const MeshFile lines = read("a.obj", v + "v 9 9 9\nl 1 5\np 5\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  expect_tetrahedron(lines, "2 loose cells (points, lines) passed over");
  const MeshFile quad = read("a.obj", "f 1/1/1 2/2/1 3//1 4\nv 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\nf 1 3 4\n");
  EXPECT_EQ(quad.soup.triangles, (Triangles{{0, 1, 2}, {0, 2, 3}, {0, 2, 3}}));
}

TEST(OffVariants, ColoursNormalsPolygonsAndComments) {
  expect_tetrahedron(
      read("a.off", "COFF\n4 4 0\n0 0 0 255 0 0 255\n1 0 0 1 1 1 1\n0 2 0 # a\n0 0 3\n" + faces));
  expect_tetrahedron(
      read("a.off", "# x\nNOFF # y\n4 4 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 2 0 1 0 0\n0 0 3 1 0 0\n" + faces));
  expect_tetrahedron(read("a.off", "STCNOFF 4 4 0\n0 0 0 0 0 1 1 1 1 1 0 0\n1 0 0\n0 2 0\n0 0 3\n" + faces));
  expect_tetrahedron(read("a.off", "OFF\n4 4 0\n" + points + faces + "2 0 1\n"),
                     "5 bytes after the surface passed over");
  EXPECT_EQ(
      read("a.off", "OFF\n4 1 0\n0 0 0\n2 0 0\n2 1 0\n0 1 0\n4 0 1 2 3 0.5 0.5 0.5\n").soup.triangles.size(),
      2u);
}

std::string big_endian_ints(const std::vector<int>& values) {
  std::string out;
  for (const int value : values) out += raw(static_cast<std::int32_t>(value), true);
  return out;
}

TEST(VtkVariants, StringFieldsLooseCellsAndStripsInText) {
  const std::string head = "# vtk DataFile Version 4.2\nx\nASCII\nDATASET POLYDATA\n",
                    p = "POINTS 5 float\n" + points + "9 9 9\n", polygons = "POLYGONS 4 16\n" + faces;
  const std::string fields =
      "FIELD FieldData 3\nNames 1 2 string\nbone of mine\n\nMETADATA\nINFORMATION 0\n\nSPACE 1 1 string\nRAS\nflags 1 3 bit\n1 0 1\n";
  const MeshFile file = read("a.vtk", head + fields + p + "VERTICES 1 2\n1 4\nLINES 1 3\n2 0 4\n" + polygons);
  expect_tetrahedron(file, "2 loose cells (points, lines) passed over");
  EXPECT_EQ(file.space, AnatomicalSpace::ras);
  const MeshFile strips =
      read("a.vtk", head + p + "TRIANGLE_STRIPS 1 5\n4 0 1 2 3\nMETADATA\nINFORMATION 0\n\nCELL_DATA 1\n");
  EXPECT_EQ(strips.soup.triangles, (Triangles{{0, 1, 2}, {2, 1, 3}}));
  EXPECT_EQ(read("a.vtk", head + p + "POLYGONS 1 5\n4 0 1 2 3\n").soup.triangles.size(), 2u);
  const MeshFile newer = read(
      "a.vtk",
      changed(head, "4.2", "5.1") + p +
          "VERTICES 0 0\nVERTICES 2 1\nOFFSETS vtktypeint64\n0 1\nCONNECTIVITY vtktypeint64\n4\n"
          "POLYGONS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n0 2 1 0 1 3 1 2 3 2 0 3\n");
  expect_tetrahedron(newer, "1 loose cell (points, lines) passed over");
}

const std::string grid =
    "# vtk DataFile Version 2.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 5 float\n" + points + "9 9 9\n";

TEST(VtkVariants, GridsOfTheCellsOfASurface) {
  const std::string cells = "CELLS 6 21\n" + faces + "1 4\n2 0 4\n";
  expect_tetrahedron(read("a.vtk", grid + cells + "CELL_TYPES 6\n5\n5\n7\n5\n1\n3\nCELL_DATA 6\n"),
                     "2 loose cells (points, lines) passed over");
  const std::string newer = changed(grid, "2.0", "5.1") +
                            "CELLS 5 12\nOFFSETS vtktypeint64\n0 3 6 9 12\nCONNECTIVITY vtktypeint64\n"
                            "0 2 1 0 1 3 1 2 3 2 0 3\nCELL_TYPES 4\n5 5 5 5\n";
  expect_tetrahedron(read("a.vtk", newer), "1 point that no face uses passed over");
  const MeshFile strip = read("a.vtk", grid + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n6\n");
  EXPECT_EQ(strip.soup.triangles, (Triangles{{0, 1, 2}, {2, 1, 3}}));
  const MeshFile quad = read("a.vtk", grid + "CELLS 1 5\n4 0 1 3 2\nCELL_TYPES 1\n9\n"),
                 pixel = read("a.vtk", grid + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n8\n");
  EXPECT_EQ(pixel.soup.triangles, quad.soup.triangles);
}

TEST(VtkVariants, GridsOfOtherCellsAreNamed) {
  const auto refusal = [](const std::string& cells) -> std::string {
    try {
      read("a.vtk", grid + cells);
    } catch (const IoError& e) {
      return e.what();
    }
    return "was read";
  };
  EXPECT_THAT(refusal("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n10\n"), HasSubstr("holds tetrahedra"));
  EXPECT_THAT(refusal("CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n22\n"), HasSubstr("holds cells of type 22"));
  EXPECT_THAT(refusal("CELLS 2 8\n3 0 1 2\n3 0 1 9\nCELL_TYPES 2\n5\n5\n"),
              HasSubstr("cell 1: uses vertex 9"));
  EXPECT_THAT(refusal("CELLS 1 4\n3 0 1 2\n"), HasSubstr("has 1 CELLS and 0 CELL_TYPES"));
  EXPECT_THAT(refusal("CELLS 1 4\n3 0 1 2\nCELL_TYPES 900\n5\n"), HasSubstr("CELL_TYPES needs 900 numbers"));
}

TEST(VtkVariants, StringsOfEveryLengthInBinary) {
  std::string bytes =
      "# vtk DataFile Version 4.2\nx\nBINARY\nDATASET POLYDATA\nFIELD f 2\nnames 1 4 string\n";
  bytes += std::string("\xc3", 1) + "abc" + std::string("\x80\x03", 2) + "abc" +
           std::string("\x40\0\0\3", 4) + "abc" + std::string("\0\0\0\0\0\0\0\3", 8) +
           "abc\nbits 1 9 bit\nxy\n";
  bytes += "POINTS 4 float\n";
  for (const Vec3& point : tetrahedron().points)
    for (int k = 0; k < 3; ++k) bytes += raw(static_cast<float>(point[k]), true);
  const std::string start = bytes;
  bytes += "\nVERTICES 1 3\n" + big_endian_ints({2, 0, 1}) + "\nPOLYGONS 4 16\n" +
           big_endian_ints({3, 0, 2, 1, 3, 0, 1, 3, 3, 1, 2, 3, 3, 2, 0, 3}) + "\n";
  expect_tetrahedron(read("a.vtk", bytes), "1 loose cell (points, lines) passed over");
  for (std::size_t length = 60; length < start.size(); ++length)
    EXPECT_THROW(read("a.vtk", start.substr(0, length)), IoError) << length;
  EXPECT_THROW(
      read("a.vtk", changed(bytes, std::string("\0\0\0\0\0\0\0\3", 8), "\x3f\xff\xff\xff\xff\xff\xff\xff")),
      IoError);
}

std::string base64(const std::string& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8U | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k)
      out += i + k < bytes.size() + 1 ? digits[group >> (18 - 6 * k) & 63U] : '=';
  }
  return out;
}

std::string by_lz4(const std::string& bytes) {
  std::string out(static_cast<std::size_t>(LZ4_compressBound(static_cast<int>(bytes.size()))), '\0');
  out.resize(static_cast<std::size_t>(LZ4_compress_default(
      bytes.data(), out.data(), static_cast<int>(bytes.size()), static_cast<int>(out.size()))));
  return out;
}

std::string by_lzma(const std::string& bytes) {
  std::string out(lzma_stream_buffer_bound(bytes.size()), '\0');
  std::size_t length = 0;
  EXPECT_EQ(lzma_easy_buffer_encode(6, LZMA_CHECK_CRC32, nullptr,
                                    reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size(),
                                    reinterpret_cast<std::uint8_t*>(out.data()), &length, out.size()),
            LZMA_OK);
  out.resize(length);
  return out;
}

// The tetrahedron as three faces and a strip, with all arrays packed.
std::string packed_vtp(const std::string& compressor, std::string (*pack)(const std::string&)) {
  const auto array = [&](const char* name, const char* type, const std::string& bytes) {
    const std::string block = pack(bytes);
    const auto size = static_cast<std::uint32_t>(bytes.size());
    const std::string header = raw(std::uint32_t{1}) + raw(size) + raw(std::uint32_t{0}) +
                               raw(static_cast<std::uint32_t>(block.size()));
    return std::string("<DataArray format=\"binary\" type=\"") + type + "\" Name=\"" + name + "\">" +
           base64(header) + base64(block) + "</DataArray>";
  };
  const auto ints = [](const std::vector<int>& values) {
    std::string out;
    for (const int value : values) out += raw(static_cast<std::int32_t>(value));
    return out;
  };
  std::string coordinates;
  for (const Vec3& p : tetrahedron().points)
    for (int k = 0; k < 3; ++k) coordinates += raw(static_cast<float>(p[k]));
  return "<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" compressor=\"" + compressor +
         "\"><PolyData><Piece NumberOfPoints=\"4\" NumberOfPolys=\"3\" NumberOfStrips=\"1\" NumberOfVerts=\"0\"><Points>" +
         array("Points", "Float32", coordinates) + "</Points><Polys>" +
         array("connectivity", "Int32", ints({0, 2, 1, 0, 1, 3, 1, 2, 3})) +
         array("offsets", "Int32", ints({3, 6, 9})) + "</Polys><Strips>" +
         array("connectivity", "Int32", ints({2, 0, 3})) + array("offsets", "Int32", ints({3})) +
         "</Strips></Piece></PolyData></VTKFile>";
}

TEST(VtpVariants, Lz4LzmaAndStrips) {
  const std::string lz4 = packed_vtp("vtkLZ4DataCompressor", by_lz4),
                    lzma = packed_vtp("vtkLZMADataCompressor", by_lzma);
  expect_tetrahedron(read("a.vtp", lz4), "1 triangle strip taken apart");
  expect_tetrahedron(read("a.vtp", lzma), "1 triangle strip taken apart");
  EXPECT_THROW(read("a.vtp", changed(lzma, "vtkLZMA", "vtkLZ4")), IoError);
}

TEST(MeshVariants, GzipByContentAndByName) {
  EXPECT_TRUE(is_mesh_file("a/L1.PLY.gz"));
  EXPECT_FALSE(is_mesh_file("L1.gz"));
  EXPECT_EQ(mesh_stem("a/L1.b.ply.gz"), "L1.b");
  EXPECT_EQ(mesh_stem("a/L1.b.stl"), "L1.b");
  for (const char* name : {"a.ply", "a.ply.gz", "a.PLY.GZ"}) {
    expect_tetrahedron(read(name, testing::packed(text_ply)));
    expect_tetrahedron(read(name, text_ply));
  }
  EXPECT_THROW(read("a.ply.gz", testing::packed(text_ply).substr(0, 60)), IoError);
}

TEST(MeshVariants, ContentDecidesAndNotTheName) {
  const TemporaryFolder folder;
  write_vtp(folder.file("a.vtp"), tetrahedron());
  const std::string vtp = testing::bytes_of(folder.file("a.vtp"));
  const std::string vtk = "# vtk DataFile Version 4.2\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n" +
                          points + "POLYGONS 4 16\n" + faces;
  for (const char* name : {"a.vtk", "a.stl", "a.obj", "a.off.gz"}) {
    expect_tetrahedron(read(name, vtp));
    expect_tetrahedron(read(name, text_ply));
    expect_tetrahedron(read(name, binary_ply()));
    expect_tetrahedron(read(name, "\xef\xbb\xbf" + vtk));
    expect_tetrahedron(read(name, "OFF\n4 4 0\n" + points + faces));
    for (const std::string& stl : {testing::binary_stl(tetrahedron()), testing::ascii_stl(tetrahedron())})
      EXPECT_EQ(read(name, stl).soup.triangles.size(), 4u);
  }
}

TEST(MeshVariants, OtherKindsOfFilesAreNamed) {
  const std::string dicom = std::string(128, '\0') + "DICM" + std::string(60, '\2');
  const std::pair<std::string, std::string> cases[] = {
      {dicom, "a DICOM file"},
      {dicom + "1.2.840.10008.5.1.4.1.1.66.4", "a DICOM segmentation (SEG)"},
      {dicom + "1.2.840.10008.5.1.4.1.1.481.3", "contours in DICOM (RTSTRUCT)"},
      {"PK\3\4xxxx", "a zip archive"},
      {"\x89PNG\r\n\x1a\n", "a picture (PNG)"},
      {"MATLAB 5.0 MAT-file, x", "a MATLAB file"},
      {"ISO-10303-21;\nHEADER;", "a STEP file"},
      {"<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\">",
       "a VTK file of the type 'UnstructuredGrid'"},
      {"<!DOCTYPE html><html>", "a web page"}};
  for (const auto& [bytes, kind] : cases)
    for (const char* name : {"a.stl", "a.vtk", "a.vtu", "a.dcm"}) try {
        read(name, bytes);
        ADD_FAILURE() << kind << " was read";
      } catch (const IoError& e) {
        EXPECT_THAT(e.what(), HasSubstr("is " + kind));
        EXPECT_THAT(e.what(), ::testing::Not(HasSubstr("damaged")));
      }
  const TemporaryFolder folder;
  for (const char* name : {"a.nii.gz", "a.mha", "IM0001"}) try {
      read_label_map(folder.file(name, dicom));
      ADD_FAILURE() << name << " was read";
    } catch (const IoError& e) {
      EXPECT_THAT(e.what(), HasSubstr("is a DICOM file"));
    }
}

// Corresponding surfaces must get the same triangles, though their diagonals differ in length.
TEST(TriangulatePolygon, ConvexPolygonsAreCutAlikeWhateverTheirShape) {
  const std::vector<Vec3> wide{{0, 0, 0}, {5, 1, 0}, {9, 3, 1}, {4, 3, 0}},
      narrow{{0, 0, 0}, {5, -4, 0}, {6, 0, 0}, {5, 4, 1}};
  const std::vector<int> quad{0, 1, 2, 3};
  EXPECT_EQ(io_detail::triangulate_polygon(quad, wide), (Triangles{{0, 1, 2}, {0, 2, 3}}));
  EXPECT_EQ(io_detail::triangulate_polygon(quad, narrow), (Triangles{{0, 1, 2}, {0, 2, 3}}));
}

// An L of six corners: ears must not be cut across the notch. Reversed, it must stay reversed.
TEST(TriangulatePolygon, ConcavePolygonsAreCoveredOnce) {
  const std::vector<Vec3> corners{{0, 0, 5}, {3, 0, 5}, {3, 1, 5}, {1, 1, 5}, {1, 3, 5}, {0, 3, 5}};
  for (const bool reversed : {false, true}) {
    std::vector<int> polygon{1, 2, 3, 4, 5, 0};
    if (reversed) std::reverse(polygon.begin(), polygon.end());
    const auto triangles = io_detail::triangulate_polygon(polygon, corners);
    ASSERT_EQ(triangles.size(), 4u);
    double area = 0;
    for (const auto& [a, b, c] : triangles) {
      const double twice = (corners[b] - corners[a]).cross(corners[c] - corners[a]).z();
      EXPECT_GT(reversed ? -twice : twice, 0);
      area += std::abs(twice) / 2;
    }
    EXPECT_DOUBLE_EQ(area, 5);
  }
  // Without area there is no ear; the corners must be used all the same.
  EXPECT_EQ(io_detail::triangulate_polygon(std::vector<int>{0, 0, 0, 0, 0}, corners).size(), 3u);
}

}  // namespace
}  // namespace foramen
