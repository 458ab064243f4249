#include "foramen/io/mesh_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

#include "foramen/core/error.hpp"
#include "io/mesh_bytes.hpp"
#include "support/meshes.hpp"
#include "support/real_data.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::ascii_stl;
using testing::binary_stl;
using testing::bytes_of;
using ::testing::HasSubstr;
using testing::in_order_of_use;
using testing::raw;
using testing::rounded_to_float;
using testing::TemporaryFolder;
using testing::tetrahedron;

void expect_equal(const TriangleSoup& a, const TriangleSoup& b) {
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.triangles, b.triangles);
}

TEST(WritePly, BytesAreThoseThatEveryConsumerTakes) {
  const TemporaryFolder folder;
  write_ply(folder.file("a.ply"), {{{1, 2, 3}, {4, 5, 6}, {7, 8, 9.5}}, {{0, 1, 2}}}, AnatomicalSpace::lps);
  std::string expected =
      "ply\nformat binary_little_endian 1.0\ncomment SPACE=LPS\nelement vertex 3\nproperty float x\nproperty "
      "float y\n"
      "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n";
  for (float x : {1.F, 2.F, 3.F, 4.F, 5.F, 6.F, 7.F, 8.F, 9.5F}) expected += raw(x);
  expected += '\3' + raw(std::int32_t{0}) + raw(std::int32_t{1}) + raw(std::int32_t{2});
  EXPECT_EQ(bytes_of(folder.file("a.ply")), expected);
}

TEST(WritePly, RoundTripIsExactToFloat) {
  const TemporaryFolder folder;
  const TriangleSoup soup = testing::bumpy_torus_soup(20, 12, 3);
  for (AnatomicalSpace space : {AnatomicalSpace::lps, AnatomicalSpace::ras}) {
    write_ply(folder.file("a.ply"), soup, space);
    const MeshFile read = read_mesh(folder.file("a.ply"));
    EXPECT_EQ(read.space, space);
    expect_equal(read.soup, rounded_to_float(soup));
  }
}

TEST(WritePly, SameBytesTwice) {
  const TemporaryFolder folder;
  const TriangleSoup soup = testing::bumpy_torus_soup(9, 7, 1);
  write_ply(folder.file("a.ply"), soup);
  write_ply(folder.file("b.ply"), soup);
  EXPECT_EQ(bytes_of(folder.file("a.ply")), bytes_of(folder.file("b.ply")));
}

TEST(WritePly, ScalarsStandBesideThePointsAndLeaveThemAlone) {
  const TemporaryFolder folder;
  const TriangleSoup soup = testing::torus_soup(12, 9);
  const std::vector<double> distances(soup.points.size(), 1.5);
  const std::vector<VertexScalar> scalars{{"distance_mm", distances}, {"seen", distances}};
  write_ply(folder.file("plain.ply"), soup);
  write_ply(folder.file("scalars.ply"), soup, AnatomicalSpace::ras, scalars);
  const MeshFile plain = read_mesh(folder.file("plain.ply")), read = read_mesh(folder.file("scalars.ply"));
  EXPECT_EQ(read.soup.points, plain.soup.points);
  EXPECT_EQ(read.soup.triangles, soup.triangles);
  EXPECT_EQ(read.space, AnatomicalSpace::ras);
  const std::string bytes = bytes_of(folder.file("scalars.ply"));
  EXPECT_THAT(bytes, HasSubstr("property float z\nproperty float distance_mm\nproperty float seen\n"));
  EXPECT_EQ(bytes.size() - bytes_of(folder.file("plain.ply")).size(),
            8 * soup.points.size() + std::string("property float distance_mm\nproperty float seen\n").size());

  const std::vector<VertexScalar> too_few{{"short", {1, 2}}};
  EXPECT_THROW(write_ply(folder.file("none.ply"), soup, AnatomicalSpace::lps, too_few), InvalidInput);
}

TEST(WriteMesh, RefusesWhatCannotBeRead) {
  const TemporaryFolder folder;
  TriangleSoup soup = tetrahedron();
  soup.triangles[2][1] = 4;
  EXPECT_THROW(write_ply(folder.file("a.ply"), soup), InvalidInput);
  soup = tetrahedron();
  soup.points[1].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(write_ply(folder.file("a.ply"), soup), InvalidInput);
  soup.points[1].y() = 1e39;
  EXPECT_THROW(write_vtp(folder.file("a.vtp"), soup), InvalidInput);
  EXPECT_EQ(folder.size(), 0);
}

// One PLY file of the tetrahedron, in every combination of encoding, number types and unrelated data.
struct PlyVariant {
  std::string encoding, coordinate, count, index, corners;
  bool extra;
};

template <class T>
std::string value(const PlyVariant& v, T number) {
  if (v.encoding == "ascii") return std::to_string(number) + " ";
  return raw(number, v.encoding == "binary_big_endian");
}

std::string typed(const PlyVariant& v, const std::string& type, int number) {
  if (type == "char" || type == "int8" || type == "uchar" || type == "uint8") {
    return v.encoding == "ascii" ? std::to_string(number) + " " : std::string(1, static_cast<char>(number));
  }
  if (type == "short" || type == "int16") return value(v, static_cast<std::int16_t>(number));
  if (type == "ushort" || type == "uint16") return value(v, static_cast<std::uint16_t>(number));
  if (type == "int" || type == "int32") return value(v, static_cast<std::int32_t>(number));
  if (type == "uint" || type == "uint32") return value(v, static_cast<std::uint32_t>(number));
  if (type == "float" || type == "float32") return value(v, static_cast<float>(number));
  return value(v, static_cast<double>(number));
}

std::string ply_of(const PlyVariant& v) {
  const TriangleSoup soup = tetrahedron();
  const std::string line_end = v.encoding == "ascii" ? "\n" : "";
  std::string out =
      "ply\nformat " + v.encoding + " 1.0\nobj_info made by a test\ncomment 3D Slicer output. SPACE=RAS\n";
  if (v.extra) out += "element camera 2\nproperty list uchar double view\nproperty short id\n";
  out += "element vertex 4\n";
  if (v.extra) out += "property uchar red\nproperty list ushort int rings\n";
  for (const char* axis : {"x", "y", "z"}) out += "property " + v.coordinate + " " + axis + "\n";
  if (v.extra) out += "property double quality\n";
  out += "element face 4\n";
  if (v.extra) out += "property float flags\n";
  out += "property list " + v.count + " " + v.index + " " + v.corners + "\n";
  if (v.extra) out += "property list uchar float texcoord\nelement tail 1\nproperty int last\n";
  out += "end_header\n";
  if (v.extra)
    for (int camera = 0; camera < 2; ++camera)
      out += typed(v, "uchar", camera) + (camera ? typed(v, "double", 7) : "") + typed(v, "short", -5) +
             line_end;
  for (const Vec3& p : soup.points) {
    if (v.extra)
      out += typed(v, "uchar", 200) + typed(v, "ushort", 2) + typed(v, "int", 8) + typed(v, "int", 9);
    for (int k = 0; k < 3; ++k) out += typed(v, v.coordinate, static_cast<int>(p[k]));
    if (v.extra) out += typed(v, "double", 1);
    out += line_end;
  }
  for (const auto& t : soup.triangles) {
    if (v.extra) out += typed(v, "float", 2);
    out += typed(v, v.count, 3);
    for (int corner : t) out += typed(v, v.index, corner);
    if (v.extra) out += typed(v, "uchar", 1) + typed(v, "float", 4);
    out += line_end;
  }
  if (v.extra) out += typed(v, "int", 99) + line_end;
  return out;
}

TEST(ReadPly, EveryEncodingTypeAndUnrelatedData) {
  const TemporaryFolder folder;
  for (const std::string encoding : {"ascii", "binary_little_endian", "binary_big_endian"})
    for (const std::string coordinate :
         {"float", "double", "float32", "float64", "char", "uint8", "short", "ushort", "int32", "uint"})
      for (const std::string index : {"int", "uint", "short", "uint16", "uchar", "int8"})
        for (const bool extra : {false, true}) {
          const PlyVariant v{encoding,
                             coordinate,
                             extra ? "uint" : "uchar",
                             index,
                             extra ? "vertex_index" : "vertex_indices",
                             extra};
          SCOPED_TRACE(encoding + " " + coordinate + " " + index + (extra ? " extra" : ""));
          const MeshFile read = read_mesh(folder.file("a.ply", ply_of(v)));
          EXPECT_EQ(read.space, AnatomicalSpace::ras);
          expect_equal(read.soup, tetrahedron());
        }
}

TEST(ReadPly, HeaderWithCarriageReturnsAndNoTag) {
  const TemporaryFolder folder;
  const MeshFile read =
      read_mesh(folder.file("a.PLY",
                            "ply\r\nformat ascii 1.0\r\ncomment NAMESPACE=XYZ\r\nelement vertex 3\r\n"
                            "property float x\r\nproperty float y\r\nproperty float z\r\nelement face 1\r\n"
                            "property list uchar int vertex_indices\r\nend_header\r\n"
                            "0 0 0\r\n1e0 +0 -0\r\n\r\n0 1 .5\r\n3 0 1 2"));
  EXPECT_EQ(read.space, std::nullopt);
  expect_equal(read.soup, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0.5}}, {{0, 1, 2}}});
}

TEST(ReadPly, FacesMayStandBeforeVertices) {
  const TemporaryFolder folder;
  const MeshFile read =
      read_mesh(folder.file("a.ply",
                            "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_index\n"
                            "element vertex 3\nproperty int x\nproperty int y\nproperty int z\nend_header\n"
                            "3 2 1 0\n0 0 0\n1 0 0\n0 1 0\n"));
  expect_equal(read.soup, {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{2, 1, 0}}});
}

TEST(ReadStl, BinaryAndTextGiveTheSameWeldedSurface) {
  const TemporaryFolder folder;
  const TriangleSoup expected = in_order_of_use(tetrahedron());
  expect_equal(read_mesh(folder.file("a.stl", binary_stl(tetrahedron()))).soup, expected);
  expect_equal(read_mesh(folder.file("b.STL", ascii_stl(tetrahedron()))).soup, expected);
}

TEST(ReadStl, SolidInABinaryHeaderDoesNotFoolIt) {
  const TemporaryFolder folder;
  for (const std::string header : {"solid", "solid cube\nfacet normal 0 0 0\n", "  SOLID x"})
    expect_equal(read_mesh(folder.file("a.stl", binary_stl(tetrahedron(), header))).soup,
                 in_order_of_use(tetrahedron()));
}

TEST(ReadStl, WeldedTorusIsTheTorus) {
  const TemporaryFolder folder;
  const TriangleSoup torus = rounded_to_float(testing::bumpy_torus_soup(30, 14, 5));
  const MeshFile read = read_mesh(folder.file("a.stl", binary_stl(torus, "3D Slicer output. SPACE=LPS")));
  EXPECT_EQ(read.space, AnatomicalSpace::lps);
  expect_equal(read.soup, in_order_of_use(torus));
  EXPECT_EQ(build_mesh(read.soup).euler_characteristic(), 0);
}

TEST(ReadStl, NegativeZeroIsZero) {
  const TemporaryFolder folder;
  const TriangleSoup soup{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, -0.0}, {0, -1, 0}},
                          {{0, 1, 2}, {3, 4, 1}}};
  EXPECT_EQ(read_mesh(folder.file("a.stl", binary_stl(soup))).soup.points.size(), 4U);
}

TEST(ReadStl, SeveralSolidsAndCapitals) {
  const TemporaryFolder folder;
  const TriangleSoup one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
      two{{{0, 0, 0}, {1, 0, 0}, {0, -1, 0}}, {{0, 2, 1}}};
  std::string text = ascii_stl(one) + "\n" + ascii_stl(two, "SPACE=RAS");
  for (char& c : text) c = static_cast<char>(std::toupper(c));
  const MeshFile read = read_mesh(folder.file("a.stl", text));
  EXPECT_EQ(read.soup.points.size(), 4U);
  EXPECT_EQ(read.soup.triangles.size(), 2U);
  EXPECT_EQ(read.space, AnatomicalSpace::ras);
}

TEST(ReadObj, EveryKindOfCorner) {
  const TemporaryFolder folder;
  const MeshFile read = read_mesh(
      folder.file("a.obj",
                  "# 3D Slicer output. SPACE=LPS\nmtllib a.mtl\no vertebra\nv 0 0 0\nv 1 0 0 1.0\n"
                  "v 0 2 0 0.5 0.5 0.5\nvt 0 0\nvn 0 0 1\ng side\nusemtl bone\ns off\n"
                  "f 1 3 2\nv 0 0 3\nf 1/1 2/1 4/1\nf 2//1 3//1 -1//-1\nf 3/1/1 1/1/1 -1/1/1 # last\r\n"));
  EXPECT_EQ(read.space, AnatomicalSpace::lps);
  expect_equal(read.soup, tetrahedron());
}

TEST(ReadObj, FacesMayUseLaterVertices) {
  const TemporaryFolder folder;
  expect_equal(read_mesh(folder.file("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n")).soup,
               {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}});
}

TEST(ReadOff, CommentsColoursAndCountsOnTheFirstLine) {
  const TemporaryFolder folder;
  const std::string body =
      "# SPACE=RAS\n0 0 0\n1 0 0 # second\n\n0 2 0\n0 0 3\n3 0 2 1\n3 0 1 3 255 0 0\n3 1 2 3\n3 2 0 3 1 0 0 "
      "1\n";
  for (const std::string head :
       {"OFF\n4 4 6\n", "# a comment\nOFF # another\n# third\n4 4 0\n", "OFF 4 4 6\n", "OFF\r\n4 4\r\n"}) {
    const MeshFile read = read_mesh(folder.file("a.off", head + body));
    EXPECT_EQ(read.space, AnatomicalSpace::ras);
    expect_equal(read.soup, tetrahedron());
  }
}

TEST(ReadMesh, NamesTheExtensionsItKnows) {
  const TemporaryFolder folder;
  try {
    read_mesh(folder.file("a.gltf", "x"));
    FAIL();
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.gltf: has the unknown extension '.gltf'"));
    EXPECT_THAT(error.what(), HasSubstr(".ply .stl .obj .off"));
  }
  EXPECT_THROW(read_mesh(folder.file("vertebra", "x")), IoError);
}

TEST(ReadMesh, RealDataKeepTheirBytes) {
  FORAMEN_NEEDS_REAL_DATA();
  const TemporaryFolder folder;
  const auto path = testing::data_dir() / "lumbar/verse005_L1.ply";
  const MeshFile read = read_mesh(path);
  EXPECT_EQ(read.space, std::nullopt);
  write_ply(folder.file("a.ply"), read.soup);
  // Only the header differs: the files say "units mm" where ours say SPACE.
  const auto body = [](const std::string& bytes) { return bytes.substr(bytes.find("end_header\n")); };
  EXPECT_EQ(body(bytes_of(folder.file("a.ply"))), body(bytes_of(path)));
}

}  // namespace
}  // namespace foramen
