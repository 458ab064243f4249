#include "modelfiles/corresponding_folder.hpp"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

// Tori a, b and c with outer radii of 28, 56 and 84 mm. The first landmark is the outermost point.
class FolderOfThree : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const int size : {2, 3, 1})
      write_ply(folder_.file(std::string(1, "abc"[size - 1]) + ".ply"),
                testing::torus_soup(8, 6, 20 * size, 8 * size),
                size == 2 ? AnatomicalSpace::ras : AnatomicalSpace::lps);
  }
  std::filesystem::path path() const { return folder_.path(); }
  template <class Work>
  std::string refusal_of(const Work& work) const {
    try {
      work();
    } catch (const InvalidInput& e) {
      return e.what();
    }
    ADD_FAILURE() << "not refused";
    return {};
  }

 private:
  testing::TemporaryFolder folder_;
};

TEST_F(FolderOfThree, IsReadInOrderOfStemWithEachFilesSpace) {
  const CorrespondingFolder read = read_corresponding(path());
  EXPECT_THAT(read.names, ElementsAre("a", "b", "c"));
  EXPECT_EQ(read.triangles, testing::torus_soup(8, 6).triangles);
  EXPECT_THAT(read.spaces, ElementsAre(AnatomicalSpace::lps, AnatomicalSpace::ras, AnatomicalSpace::lps));
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(read.shapes.at(i).at(0), Vec3(28.0 * static_cast<double>(i + 1), 0, 0));
}

TEST_F(FolderOfThree, UnitsBecomeMillimetres) {
  const testing::TemporaryFolder centimetres;
  write_ply(centimetres.file("a.ply"), testing::torus_soup(8, 6, 2, 0.8));
  const CorrespondingFolder read = read_corresponding(centimetres.path(), LengthUnit::centimetre);
  EXPECT_LT((read.shapes.at(0).at(0) - Vec3(28, 0, 0)).norm(), 1e-5);
  EXPECT_TRUE(read.notes.empty());
  EXPECT_THAT(refusal_of([&] { read_corresponding(centimetres.path()); }),
              HasSubstr("a.ply: the bounding box"));
  EXPECT_EQ(read_corresponding(centimetres.path(), {LengthUnit::millimetre, true}).notes.size(), 1);
}

TEST_F(FolderOfThree, AMeshOfOtherTrianglesIsNamed) {
  write_ply(path() / "b.ply", testing::renumbered(testing::torus_soup(8, 6), 1));
  EXPECT_THAT(refusal_of([&] { read_corresponding(path()); }), HasSubstr("b.ply: "));
  TriangleSoup more = testing::torus_soup(8, 6);
  more.points.emplace_back(0, 0, 0);
  write_ply(path() / "b.ply", more);
  EXPECT_THAT(refusal_of([&] { read_corresponding(path()); }), HasSubstr("b.ply: "));
}

TEST_F(FolderOfThree, TheTruthComesInTheOrderAskedForAndMayHaveMore) {
  const TrueCorrespondence truth = read_truth(path(), {"c", "a"});
  ASSERT_EQ(truth.shapes.size(), 2u);
  EXPECT_EQ(truth.shapes[0].at(0), Vec3(84, 0, 0));
  EXPECT_EQ(truth.shapes[1].at(0), Vec3(28, 0, 0));
  EXPECT_EQ(truth.triangles, testing::torus_soup(8, 6).triangles);
}

TEST_F(FolderOfThree, TheTruthOfFoldersIsFoundByTheirNames) {
  for (const char* patient : {"p1", "p2"}) {
    std::filesystem::create_directory(path() / patient);
    std::filesystem::copy_file(path() / (patient[1] == '1' ? "a.ply" : "c.ply"), path() / patient / "L1.ply");
  }
  const TrueCorrespondence truth = read_truth(path(), {"p2_L1", "p1_L1"});
  EXPECT_EQ(truth.shapes.at(0).at(0), Vec3(84, 0, 0));
  EXPECT_EQ(truth.shapes.at(1).at(0), Vec3(28, 0, 0));
  std::filesystem::remove_all(path() / "p2");
  EXPECT_EQ(read_truth(path(), {"p1_L1"}).shapes.at(0).at(0), Vec3(28, 0, 0)) << "a part of the cohort";
}

TEST_F(FolderOfThree, AShapeWithoutTruthIsNamed) {
  EXPECT_THAT(refusal_of([&] { read_truth(path(), {"a", "nobody"}); }), HasSubstr("the shape nobody"));
}

}  // namespace
}  // namespace foramen
