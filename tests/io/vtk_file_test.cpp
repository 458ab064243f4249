// Legacy VTK by our own reader; VTP through VTK: what must never reach it, and the one clear error without
// it.
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

bool built_with_vtk() {
  const auto& known = mesh_extensions();
  return std::find(known.begin(), known.end(), ".vtp") != known.end();
}

#define FORAMEN_NEEDS_VTK() \
  if (!built_with_vtk()) GTEST_SKIP() << "this build has no VTK"

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

// With all that VTK 9 adds.
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

TEST(VtkFile, WithoutVtkTheErrorSaysSo) {
  if (built_with_vtk()) GTEST_SKIP() << "this build has VTK";
  const TemporaryFolder folder;
  expect_refused(folder.file("a.vtp", "<VTKFile>"), "this build of foramen reads no VTP files");
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
  FORAMEN_NEEDS_VTK();
  const TemporaryFolder folder;
  for (int tube : {7, 8, 9}) {  // every remainder of the bytes by three
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
      {replaced(legacy_text, "POLYGONS", "TRIANGLE_STRIPS"), "line 8: triangle strips"},
      {replaced(legacy_text, "POLYGONS 4 16", "LINES 1 3\n2 0 1\nPOLYGONS 4 16"),
       "line 8: loose points or lines"},
      {replaced(legacy_text, "POLYGONS", "POLYGON"), "line 8: unknown section 'POLYGON 4 16'"},
      {legacy_text.substr(0, legacy_text.find("DATASET")), "the file ends before DATASET"},
      {binary.substr(0, binary.size() - 9), "POLYGONS needs 16 numbers, more than the 56 bytes that follow"},
      {replaced(legacy_text, "3 1 2 3", "3 1 2 4"), "face 2: uses vertex 4"},
      {replaced(legacy_text, "3 1 2 3", "3 1 2 -1"), "face 2: uses vertex -1"},
      {replaced(legacy_text, "POLYGONS 4 16\n3 0 2 1\n", "POLYGONS 4 17\n4 0 2 1 3\n"),
       "face 0: a face with 4 corners"},
      {replaced(legacy_text, "1 0 0", "1 nan 0"), "vertex 1: a coordinate is not a finite number"},
      {replaced(legacy_5, "0 3 6 9 12", "0 3 9 6 12"), "face 1: a face with 6 corners"},
      {replaced(legacy_5, "0 3 6 9 12", "0 3 6 9 13"),
       "face 3: its offsets 9 and 13 are out of order or range"},
      {replaced(legacy_5, "OFFSETS vtktypeint64", "OFFSETS double"), "OFFSETS must be integers"},
      {replaced(legacy_5, "CONNECTIVITY", "OFFSETS"), "expected CONNECTIVITY, found 'OFFSETS vtktypeint64'"},
      {legacy_text.substr(0, legacy_text.find("POLYGONS")), "holds no triangles"}};
  for (const auto& [bytes, message] : cases) expect_refused(folder.file("a.vtk", bytes), message);
}

TEST(VtkFile, MalformedVtpIsRefused) {
  FORAMEN_NEEDS_VTK();
  const TemporaryFolder folder;
  write_vtp(folder.file("good.vtp"), tetrahedron());
  const std::string good = testing::bytes_of(folder.file("good.vtp"));
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"<html></html>", "has no <VTKFile> element"},
      {replaced(good, "\"PolyData\"", "\"ImageData\""), "is no PolyData"},
      {good.substr(0, good.size() / 2), "does not end with </VTKFile>"},
      {replaced(good, "NumberOfPoints=\"4\"", "NumberOfPoints=\"9000000000\""),
       "announces '9000000000' as NumberOfPoints"},
      {replaced(good, "NumberOfPolys=\"4\"", "NumberOfPolys=\"many\""), "announces 'many' as NumberOfPolys"},
      {replaced(good, "</Points>", "</Pints>"), "VTK cannot read it"},
      {replaced(good, "NumberOfPoints=\"4\"", "NumberOfPoints=\"40\""), "VTK cannot read it"},
      {replaced(good, "NumberOfPoints=\"4\"", "NumberOfPoints=\"3\""),
       "uses vertex 3, but there are 3 vertices"}};
  for (const auto& [bytes, message] : cases) expect_refused(folder.file("a.vtp", bytes), message);
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
        bytes[static_cast<std::size_t>(rng.below(static_cast<int>(bytes.size())))] =
            static_cast<char>(rng.below(256));
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
