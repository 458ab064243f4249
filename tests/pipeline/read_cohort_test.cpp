#include "foramen/pipeline/read_cohort.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/pipeline/run_build.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using testing::TemporaryFolder;
using testing::torus_soup;

template <class Work>
std::string refusal(const Work& work) {
  try {
    work();
  } catch (const Error& e) {
    return e.what();
  }
  ADD_FAILURE() << "not refused";
  return {};
}

TEST(FindMeshes, FilesAndFoldersInOrderOfStem) {
  const TemporaryFolder folder;
  for (const char* name : {"b.ply", "a.PLY", "notes.txt"}) folder.file(name, "");
  const auto found = find_meshes({folder.path(), folder.path() / "b.ply"});
  ASSERT_EQ(found.size(), 2u);
  EXPECT_EQ(found[0].filename(), "a.PLY");
  EXPECT_EQ(found[1].filename(), "b.ply");
}

TEST(FindMeshes, RefusesWhatIsMissingEmptyOrAmbiguous) {
  const TemporaryFolder folder;
  EXPECT_THAT(refusal([&] { find_meshes({folder.path() / "none.ply"}); }), HasSubstr("no such file"));
  EXPECT_THAT(refusal([&] { find_meshes({folder.path()}); }), HasSubstr("holds no mesh file"));
  folder.file("a.ply", "");
  folder.file("a.stl", "");
  EXPECT_THAT(refusal([&] { find_meshes({folder.path()}); }), HasSubstr("same name"));
}

TEST(ReadShape, InwardWindingIsReversedAndSaid) {
  const TemporaryFolder folder;
  TriangleSoup soup = torus_soup(24, 12);
  for (auto& t : soup.triangles) std::swap(t[0], t[1]);
  write_ply(folder.file("in.ply"), soup, AnatomicalSpace::ras);
  const InputShape shape = read_shape(folder.file("in.ply"), LengthUnit::millimetre);
  EXPECT_TRUE(shape.was_inward);
  EXPECT_GT(signed_volume(shape.mesh), 0);
  EXPECT_EQ(shape.space, AnatomicalSpace::ras);
  EXPECT_EQ(shape.sha256.size(), 64u);
}

TEST(ReadShape, UnitsAreConvertedAndImplausibleOnesRefused) {
  const TemporaryFolder folder;
  TriangleSoup soup = torus_soup(24, 12);
  const double area_mm = total_area(build_mesh(soup));
  for (Vec3& p : soup.points) p /= 10;
  write_ply(folder.file("cm.ply"), soup);
  EXPECT_NEAR(total_area(read_shape(folder.file("cm.ply"), LengthUnit::centimetre).mesh) / area_mm, 1, 1e-5);
  EXPECT_THAT(refusal([&] { read_shape(folder.file("cm.ply"), LengthUnit::millimetre); }),
              HasSubstr("--units cm"));
}

TEST(ReadCohort, OneBadFileIsLeftOutWithItsReason) {
  const TemporaryFolder folder;
  write_ply(folder.file("good.ply"), torus_soup(24, 12));
  TriangleSoup open = torus_soup(24, 12);
  open.triangles.pop_back();
  write_ply(folder.file("open.ply"), open);
  folder.file("torn.ply", "ply\nformat ascii 1.0\n");
  const Cohort cohort = read_cohort(find_meshes({folder.path()}), LengthUnit::millimetre, RunContext(2));
  ASSERT_EQ(cohort.shapes.size(), 1u);
  ASSERT_EQ(cohort.left_out.size(), 2u);
  EXPECT_THAT(cohort.left_out[0].reason, HasSubstr("open.ply"));
  EXPECT_THAT(cohort.left_out[1].reason, HasSubstr("torn.ply"));
}

TEST(SubjectOf, TakesTheFirstGroupOrTheWholeMatch) {
  EXPECT_EQ(subject_of("verse005_L1", "(.*)_L"), "verse005");
  EXPECT_EQ(subject_of("verse005_L1", "verse[0-9]+"), "verse005");
  EXPECT_EQ(subject_of("other", "verse[0-9]+"), "other");
  EXPECT_THROW(subject_of("x", "("), InvalidInput);
}

}  // namespace
}  // namespace foramen
