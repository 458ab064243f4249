// Each file has one defect. It must be refused with an error that names the defect, whatever the header
// claims.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/io/mesh_file.hpp"
#include "io/malformed_meshes.hpp"
#include "io/mesh_bytes.hpp"
#include "io/mesh_formats.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using testing::ascii_stl;
using testing::binary_stl;
namespace malformed = testing::malformed;
using malformed::Malformed;
using malformed::ply;
using testing::TemporaryFolder;
using testing::tetrahedron;

class MalformedMesh : public ::testing::TestWithParam<Malformed> {};

TEST_P(MalformedMesh, IsRefusedByName) {
  const TemporaryFolder folder;
  const Malformed& m = GetParam();
  const auto path = folder.file("broken." + m.extension, m.bytes);
  try {
    read_mesh(path);
    FAIL() << "was read";
  } catch (const IoError& error) {
    EXPECT_THAT(error.what(), ::testing::StartsWith(path.string() + ": "));
    EXPECT_THAT(error.what(), ::testing::HasSubstr(m.message));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("; ")) << "what to do is missing";
  }
}

const auto case_name = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Ply, MalformedMesh, ::testing::ValuesIn(malformed::ply_files()), case_name);
INSTANTIATE_TEST_SUITE_P(Stl, MalformedMesh, ::testing::ValuesIn(malformed::stl_files()), case_name);
INSTANTIATE_TEST_SUITE_P(Obj, MalformedMesh, ::testing::ValuesIn(malformed::obj_files()), case_name);
INSTANTIATE_TEST_SUITE_P(Off, MalformedMesh, ::testing::ValuesIn(malformed::off_files()), case_name);

TEST(MissingMesh, IsRefusedByName) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.file("folder.ply"));
  for (const auto& [name, message] :
       {std::pair("none.ply", "no such file"), std::pair("folder.ply", "is a folder")})
    try {
      read_mesh(folder.file(name));
      FAIL();
    } catch (const IoError& error) {
      EXPECT_THAT(error.what(), ::testing::HasSubstr(message));
    }
}

// If any bytes of a file change, the file is either refused with an IoError or read as a valid soup.
TEST(DamagedMesh, IsReadSoundOrRefused) {
  const TemporaryFolder folder;
  write_ply(folder.file("a.ply"), tetrahedron());
  using Parse = MeshFile (*)(const io_detail::Source&);
  const std::vector<std::pair<Parse, std::string>> files = {
      {io_detail::parse_ply, testing::bytes_of(folder.file("a.ply"))},
      {io_detail::parse_ply,
       ply("4", "4", "0 0 0\n1 0 0\n0 2 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")},
      {io_detail::parse_stl, binary_stl(tetrahedron())},
      {io_detail::parse_stl, ascii_stl(tetrahedron())},
      {io_detail::parse_obj,
       "v 0 0 0\nv 1 0 0\nv 0 2 0\nv 0 0 3\nf 1 3 2\nf 1//1 2//2 4//3\nf 2/1 3/1 -1/1\nf 3 1 4\n"},
      {io_detail::parse_off, "OFF\n4 4 6\n0 0 0\n1 0 0\n0 2 0\n0 0 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"}};
  int read = 0, refused = 0;
  Rng rng(11);
  for (const auto& [parse, good] : files)
    for (int round = 0; round < 2000; ++round) {
      std::string bytes = good;
      for (int change = 0; change <= rng.below(3); ++change)
        bytes[rng.below(static_cast<int>(bytes.size()))] = static_cast<char>(rng.below(256));
      if (rng.below(4) == 0) bytes.resize(rng.below(static_cast<int>(bytes.size())));
      try {
        const TriangleSoup soup = parse({"file", bytes}).soup;
        for (const Vec3& p : soup.points) EXPECT_TRUE(p.allFinite());
        for (const auto& t : soup.triangles)
          for (int corner : t) EXPECT_TRUE(corner >= 0 && corner < std::ssize(soup.points));
        ++read;
      } catch (const IoError&) {
        ++refused;
      }
    }
  EXPECT_GT(read, 100);
  EXPECT_GT(refused, 100);
}

}  // namespace
}  // namespace foramen
