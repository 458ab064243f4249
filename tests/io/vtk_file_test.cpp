// Surfaces in VTK's legacy and XML formats.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/io/mesh_file.hpp"
#include "io/mesh_bytes.hpp"
#include "io/mesh_formats.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::raw;
using testing::TemporaryFolder;
using testing::tetrahedron;

const std::filesystem::path written_by_vtk =
    std::filesystem::path(FORAMEN_TESTS_DIR) / "io" / "written_by_vtk";

void expect_refused(const std::filesystem::path& path, const std::string& message) {
  SCOPED_TRACE(message);
  try {
    read_mesh(path);
    FAIL() << "was read";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith(path.string() + ": "));
    EXPECT_THAT(error.what(), ::testing::HasSubstr(message));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("; "));
  }
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

const std::string legacy_text =
    "# vtk DataFile Version 3.0\n3D Slicer output. SPACE=RAS\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n0 0 0 "
    "1 0 0 0 2 0\n"
    "0 0 3\nPOLYGONS 4 16\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

// A legacy file with all additions of VTK 9.
const std::string legacy_5 =
    "# vtk DataFile Version 5.1\nvtk output SPACE=LPS\nASCII\nDATASET POLYDATA\nFIELD FieldData 1\nages 2 2 "
    "double\n1 2 3 4 \n"
    "POINTS 4 double\n0 0 0 1 0 0\n0 2 0 0 0 3\n\nMETADATA\nINFORMATION 1\nNAME x LOCATION y\nDATA "
    "1\n\nPOLYGONS 5 12\n"
    "OFFSETS vtktypeint64\n0 3 6 9 12 \nCONNECTIVITY vtktypeint64\n0 2 1 0 1 3 1 2 3 \n2 0 3\nCELL_DATA "
    "4\nanything";

std::string legacy_binary() {
  std::string out = "# vtk DataFile Version 3.0\ntitle\nBINARY\nDATASET POLYDATA\nPOINTS 4 float\n";
  for (const Vec3& p : tetrahedron().points)
    for (int k = 0; k < 3; ++k) out += raw(static_cast<float>(p[k]), true);
  out += "\nPOLYGONS 4 16\n";
  for (const auto& t : tetrahedron().triangles) {
    out += raw(std::int32_t{3}, true);
    for (int corner : t) out += raw(static_cast<std::int32_t>(corner), true);
  }
  return out + "\n";
}

TEST(VtkFile, ReadsLegacyTextAndBinary) {
  const TemporaryFolder folder;
  const MeshFile text = read_mesh(folder.file("a.vtk", legacy_text));
  EXPECT_EQ(text.space, AnatomicalSpace::ras);
  EXPECT_EQ(text.soup.points, tetrahedron().points);
  EXPECT_EQ(text.soup.triangles, tetrahedron().triangles);
  const MeshFile newer = read_mesh(folder.file("c.vtk", legacy_5));
  EXPECT_EQ(newer.space, AnatomicalSpace::lps);
  EXPECT_EQ(newer.soup.points, tetrahedron().points);
  EXPECT_EQ(newer.soup.triangles, tetrahedron().triangles);
  const MeshFile binary = read_mesh(folder.file("b.vtk", legacy_binary()));
  EXPECT_EQ(binary.space, std::nullopt);
  EXPECT_EQ(binary.soup.points, tetrahedron().points);
  EXPECT_EQ(binary.soup.triangles, tetrahedron().triangles);
}

TEST(VtkFile, VtpRoundTripIsExactToFloat) {
  const TemporaryFolder folder;
  for (int tube : {7, 8, 9}) {  // the number of bytes takes every remainder modulo three
    const TriangleSoup soup = testing::bumpy_torus_soup(10, tube, 4);
    for (AnatomicalSpace space : {AnatomicalSpace::lps, AnatomicalSpace::ras}) {
      write_vtp(folder.file("a.vtp"), soup, space);
      const MeshFile read = read_mesh(folder.file("a.vtp"));
      EXPECT_EQ(read.space, space);
      EXPECT_EQ(read.soup.triangles, soup.triangles);
      EXPECT_EQ(read.soup.points, testing::rounded_to_float(soup).points);
    }
  }
}

TEST(VtkFile, MalformedLegacyIsRefused) {
  const TemporaryFolder folder;
  const std::string binary = legacy_binary();
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"what", "does not begin with '# vtk DataFile Version'"},
      {replaced(legacy_text, "ASCII", "TEXT"), "line 3: expected ASCII or BINARY"},
      {replaced(legacy_text, "POLYDATA", "STRUCTURED_POINTS"), "line 4: expected 'DATASET POLYDATA'"},
      {replaced(legacy_text, "POINTS 4", "POINTS 2000000000"), "line 5: POINTS needs 2000000000 numbers"},
      {replaced(legacy_text, "POINTS 4", "POINTS 9223372036854775807"), "line 5: POINTS needs"},
      {replaced(legacy_text, "POINTS 4", "POINTS -4"), "line 5: expected a count, found '-4'"},
      {replaced(legacy_text, "POINTS 4 float", "POINTS 4 string"), "numbers of type 'string' are not read"},
      {replaced(legacy_text, "POINTS 4", "POINTS 5"),
       "line 8: expected a number in POINTS, found 'POLYGONS'"},
      {replaced(legacy_text, "POINTS 4", "POINTS 3"), "line 7: unknown section '0 0 3'"},
      {replaced(legacy_text, "POLYGONS 4 16", "POLYGONS 4000000 16000000"),
       "POLYGONS needs 16000000 numbers"},
      {replaced(legacy_text, "POLYGONS 4 16", "POLYGONS 4 15"),
       "face 3 of POLYGONS does not fit its announced size"},
      {replaced(legacy_text, "POLYGONS 4 16", "POLYGONS 3 16"), "POLYGONS has other than its announced size"},
      {replaced(legacy_text, "3 1 2 3", "3 1 2 4")
           .replace(legacy_text.find("POLYGONS"), 8, "TRIANGLE_STRIPS"),
       "strip 2: uses vertex 4"},
      {replaced(legacy_text, "POLYGONS 4 16", "LINES 2 3\n2 0 1\nPOLYGONS 4 16"),
       "face 1 of LINES does not fit its announced size"},
      {replaced(legacy_text, "POINTS", "FIELD f 1\nx 99999999999 99999999999 bit\nPOINTS"),
       "FIELD needs more numbers"},
      {replaced(legacy_text, "POINTS", "FIELD f 1\nx 1 90 string\nPOINTS"), "the file ends within FIELD"},
      {replaced(legacy_text, "POLYGONS", "POLYGON"), "line 8: unknown section 'POLYGON 4 16'"},
      {legacy_text.substr(0, legacy_text.find("DATASET")), "the file ends before DATASET"},
      {binary.substr(0, binary.size() - 9), "POLYGONS needs 16 numbers, more than the 56 bytes that follow"},
      {replaced(legacy_text, "3 1 2 3", "3 1 2 4"), "face 2: uses vertex 4"},
      {replaced(legacy_text, "3 1 2 3", "3 1 2 -1"), "face 2: uses vertex -1"},
      {replaced(legacy_text, "1 0 0", "1 nan 0"), "vertex 1: a coordinate is not a finite number"},
      {replaced(legacy_5, "0 3 6 9 12", "0 3 9 6 12"), "face 2: its offsets 9 and 6 are out of order"},
      {replaced(legacy_5, "0 3 6 9 12", "0 3 6 9 13"),
       "face 3: its offsets 9 and 13 are out of order or range"},
      {replaced(legacy_5, "OFFSETS vtktypeint64", "OFFSETS double"), "OFFSETS must be integers"},
      {replaced(legacy_5, "CONNECTIVITY", "OFFSETS"), "expected CONNECTIVITY, found 'OFFSETS vtktypeint64'"},
      {legacy_text.substr(0, legacy_text.find("POLYGONS")), "holds no triangles"}};
  for (const auto& [bytes, message] : cases) expect_refused(folder.file("a.vtk", bytes), message);
}

// Files that VTK 9.1 wrote: text, inline and appended binary, base64 and raw, zlib in blocks, both byte
// orders, both sizes of header.
TEST(VtkFile, ReadsWhatVtkWrites) {
  TriangleSoup expected;
  constexpr int around = 5, tube = 4;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < tube; ++j) expected.points.emplace_back(i + 0.1, j / 3.0, (i * tube + j) * 0.25 - 1);
  expected.triangles = testing::torus_soup(around, tube).triangles;
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(written_by_vtk)) {
    SCOPED_TRACE(entry.path().filename());
    const MeshFile read = read_mesh(entry.path());
    EXPECT_EQ(read.soup.triangles, expected.triangles);
    ASSERT_EQ(read.soup.points.size(), expected.points.size());
    // Numbers in text have eleven digits.
    for (std::size_t v = 0; v < expected.points.size(); ++v)
      EXPECT_LT((read.soup.points[v] - expected.points[v]).norm(),
                entry.path().filename() == "ascii.vtp" ? 1e-9 : 1e-300);
    EXPECT_EQ(read.space, AnatomicalSpace::ras);
    ++files;
  }
  EXPECT_EQ(files, 7);
}

std::string vtp(const std::string& piece, const std::string& attributes = "") {
  return "<VTKFile type=\"PolyData\" " + attributes + "><PolyData>" + piece + "</PolyData></VTKFile>";
}

std::string text_piece(const std::string& points, const std::string& corners, const std::string& ends,
                       int point_count, int face_count) {
  const std::string array = "</DataArray><DataArray type=\"Int32\" format=\"ascii\" Name=";
  return "<Piece NumberOfPoints=\"" + std::to_string(point_count) + "\" NumberOfPolys=\"" +
         std::to_string(face_count) + "\"><Points><DataArray type=\"Float32\" format=\"ascii\">" + points +
         "</DataArray></Points><Polys><DataArray type=\"Int32\" format=\"ascii\" Name=\"connectivity\">" +
         corners + array + "\"offsets\">" + ends + "</DataArray></Polys></Piece>";
}

const std::string square = "0 0 0 1 0 0 1 1 0 0 1 0";

TEST(VtkFile, PiecesAreOneSurface) {
  const std::string one = text_piece(square, "0 1 2 0 2 3", "3 6", 4, 2),
                    other = text_piece("5 5 5 6 5 5 5 6 5", "2 0 1", "3", 3, 1);
  const TriangleSoup soup = io_detail::parse_vtp({"file", vtp(one + other)}).soup;
  EXPECT_EQ(soup.points.size(), 7u);
  EXPECT_EQ(soup.triangles, (std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {6, 4, 5}}));
}

TEST(VtkFile, FurtherAttributesOfTheRootDoNotMatter) {
  const TemporaryFolder folder;
  write_vtp(folder.file("good.vtp"), tetrahedron());
  const std::string good = testing::bytes_of(folder.file("good.vtp"));
  const auto file = folder.file("reordered.vtp", replaced(good, "<VTKFile type=\"PolyData\"",
                                                          "<VTKFile their_type=\"x\" type=\"PolyData\""));
  EXPECT_EQ(read_mesh(file).soup.triangles.size(), 4u);
}

TEST(VtkFile, MalformedVtpIsRefused) {
  const TemporaryFolder folder;
  write_vtp(folder.file("good.vtp"), tetrahedron());
  const std::string good = testing::bytes_of(folder.file("good.vtp"));
  const auto whole = [](const std::string& name) { return testing::bytes_of(written_by_vtk / name); };
  const auto text = [](const std::string& corners, const std::string& ends) {
    return vtp(text_piece(square, corners, ends, 4, 2));
  };
  std::string nested;
  for (int i = 0; i < 30; ++i) nested += "<a>";
  std::string many;
  for (int i = 0; i < 1000000; ++i) many += "<a/>";
  const std::string zlib = whole("inline_zlib.vtp"), raw = whole("appended_raw.vtp");
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"<other></other>", "has no <VTKFile> element"},
      {replaced(good, "\"PolyData\"", "\"ImageData\""), "is a VTK file of the type 'ImageData'"},
      {"<VTKFile version=\"1.0\"><A type=\"Float32\"/></VTKFile>", "is no PolyData"},
      {good.substr(0, good.size() / 2), "does not end with </VTKFile>"},
      {replaced(good, "NumberOfPoints=\"4\"", "NumberOfPoints=\"9000000000000000000\""),
       "its array 'Points' holds 12 numbers instead of 3 x 9000000000000000000"},
      {replaced(good, "NumberOfPolys=\"4\"", "NumberOfPolys=\"many\""), "announces 'many' as NumberOfPolys"},
      {replaced(good, "NumberOfPolys=\"4\"", "NumberOfPolys=\"5\""),
       "its array 'offsets' holds 4 numbers instead of 5"},
      {replaced(good, "</Points>", "</Pints>"), "is no well-formed XML (mismatched tag)"},
      {replaced(good, "<?xml version=\"1.0\"?>", "<?xml version=\"1.0\"?><!DOCTYPE lolz []>"),
       "declares a document type"},
      {replaced(good, "<Points>", nested + "<Points>"), "is nested deeper than 20 elements"},
      {replaced(good, "<Points>", many + "<Points>"), "has more than 1000000 elements"},
      {replaced(good, "NumberOfPoints=\"4\"", "NumberOfPoints=\"40\""), "holds 12 numbers instead of 3 x 40"},
      {replaced(good, "NumberOfStrips=\"0\"", "NumberOfStrips=\"1\""), "has no"},
      {replaced(good, "Name=\"connectivity\"", "Name=\"disconnectivity\""),
       "has no array 'connectivity' in <Polys>"},
      {replaced(good, "<Polys>", "<Pol>"), "is no well-formed XML"},
      {replaced(good, "format=\"binary\"", "format=\"spoken\""),
       "has an array of the unknown format 'spoken'"},
      {replaced(good, "format=\"binary\"", "format=\"appended\" offset=\"7\""),
       "has an array at '7' of 0 appended bytes"},
      {replaced(good, "\"Int32\" Name=\"connectivity\"", "\"Float32\" Name=\"connectivity\""),
       "has an array 'connectivity' of type 'Float32'"},
      {replaced(good, "MAAAAAAA", "MAAA?AAA"), "holds '?AAA' in base64 data"},
      {replaced(good, "MAAAAAAA", "MAAAAAAQ"),
       "announces an array of 17592186044464 bytes, more than the file holds"},
      {replaced(zlib, "vtkZLibDataCompressor", "vtkNewDataCompressor"),
       "is compressed by 'vtkNewDataCompressor'"},
      {replaced(zlib, "vtkZLibDataCompressor", "vtkLZ4DataCompressor"), "holds a damaged compressed block"},
      {replaced(zlib, "vtkZLibDataCompressor", "vtkLZMADataCompressor"), "holds a damaged compressed block"},
      {replaced(zlib, "CAAAAAAAAABAAAAAAAAAACAA", "CAAAAAAAAABAAAAAAAAAAEAA"),
       "holds a damaged compressed block"},
      {replaced(zlib, "CAAAAAAAAABAAAAA", "CAAAAAAAAABAAAAQ"), "cannot be compressed so densely"},
      {replaced(zlib, "CAAAAAAAAABAAAAA", "CAAAAAAAAP9AAAAA"), "compressed"},
      {raw.substr(0, raw.find("_") + 700) + "</AppendedData></VTKFile>", "of"},
      {text("0 1 2 0 2 4", "3 6"), "face 1: uses vertex 4, but there are 4 vertices"},
      {text("0 1 2 0 2 -1", "3 6"), "face 1: uses vertex -1"},
      {text("0 1 2 0 2 3", "3 7"), "face 1: its offsets 3 and 7 are out of order or range"},
      {text("0 1 2 0 2 3", "6 3"), "face 1: its offsets 6 and 3 are out of order"},
      {text("0 1 2 0 2 3.5", "3 6"), "expected a number, found '3.5'"},
      {replaced(text("0 1 2 0 2 3", "3 6"), "1 1 0", "1 inf 0"),
       "vertex 2: a coordinate is not a finite number"},
      {vtp(""), "holds no triangles"}};
  for (const auto& [bytes, message] : cases) expect_refused(folder.file("a.vtp", bytes), message);
}

TEST(VtkFile, DamagedVtpIsReadSoundOrRefused) {
  Rng rng(6);
  int refused = 0;
  for (const auto& entry : std::filesystem::directory_iterator(written_by_vtk)) {
    const std::string whole = testing::bytes_of(entry.path());
    for (int round = 0; round < 500; ++round) {
      std::string bytes = whole;
      for (int change = 0; change <= rng.below(3); ++change)
        bytes[rng.below(static_cast<int>(bytes.size()))] = static_cast<char>(rng.below(256));
      try {
        const TriangleSoup soup = io_detail::parse_vtp({"file", bytes}).soup;
        for (const Vec3& p : soup.points) EXPECT_TRUE(p.allFinite());
        for (const auto& t : soup.triangles)
          for (int corner : t) EXPECT_TRUE(corner >= 0 && corner < std::ssize(soup.points));
      } catch (const IoError&) {
        ++refused;
      }
    }
  }
  EXPECT_GT(refused, 500);
}

TEST(VtkFile, LegacyCutAnywhereIsRefused) {
  const std::string binary = legacy_binary();
  for (const std::string& whole : {legacy_text, binary, legacy_5.substr(0, legacy_5.find("CELL_DATA"))})
    for (std::size_t length = 0; length + 2 < whole.size(); ++length)
      EXPECT_THROW(io_detail::parse_vtk({"file", std::string_view(whole).substr(0, length)}), IoError)
          << length;
}

TEST(VtkFile, DamagedLegacyIsReadSoundOrRefused) {
  Rng rng(5);
  int refused = 0;
  for (const std::string& whole : {legacy_text, legacy_binary(), legacy_5})
    for (int round = 0; round < 2000; ++round) {
      std::string bytes = whole;
      for (int change = 0; change <= rng.below(3); ++change)
        bytes[rng.below(static_cast<int>(bytes.size()))] = static_cast<char>(rng.below(256));
      try {
        const TriangleSoup soup = io_detail::parse_vtk({"file", bytes}).soup;
        for (const Vec3& p : soup.points) EXPECT_TRUE(p.allFinite());
        for (const auto& t : soup.triangles)
          for (int corner : t) EXPECT_TRUE(corner >= 0 && corner < std::ssize(soup.points));
      } catch (const IoError&) {
        ++refused;
      }
    }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace foramen
