#include "inputs/find_files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "support/messages.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using testing::refusal;
using testing::says;
using ::testing::SizeIs;

class FindFiles : public ::testing::Test {
 protected:
  fs::path file(const std::string& path) const {
    const fs::path full = folder_.path() / path;
    fs::create_directories(full.parent_path());
    std::ofstream(full) << "x";
    return full;
  }
  fs::path top() const { return folder_.path(); }
  static std::vector<std::string> names(const FoundFiles& found) {
    std::vector<std::string> all;
    for (const ShapeFile& f : found.files) all.push_back(f.name);
    return all;
  }
  static std::vector<std::string> folders(const FoundFiles& found) {
    std::vector<std::string> all;
    for (const ShapeFile& f : found.files) all.push_back(f.folder);
    return all;
  }
  testing::TemporaryFolder folder_;
};

TEST_F(FindFiles, SubfoldersAreSearched) {
  file("b/c/L3.ply");
  file("b/L2.ply");
  file("L1.ply");
  const FoundFiles found = find_meshes({top()});
  EXPECT_THAT(names(found), ElementsAre("L1", "L2", "L3"));
  EXPECT_THAT(folders(found), ElementsAre("", "", ""));
  EXPECT_THAT(found.notes, IsEmpty());
}

TEST_F(FindFiles, HiddenOnesLinksAndModelsArePassedOverWithANote) {
  file("L1.ply");
  file(".cache/L2.ply");
  file("._L1.ply");
  file("model/run.json");
  file("model/mean.ply");
  file("older/model.h5");
  file("older/corresponding/L1.ply");
  fs::create_directory_symlink(top(), top() / "loop");
  const FoundFiles found = find_meshes({top()});
  EXPECT_THAT(names(found), ElementsAre("L1"));
  EXPECT_THAT(found.notes, AllOf(SizeIs(4), Contains(says("hidden folders")), Contains(says("hidden files")),
                                 Contains(says("links to folders")), Contains(says("folder of a model"))));
}

TEST_F(FindFiles, AModelGivenByItselfIsRefusedWithTheReason) {
  file("model/model.h5");
  file("model/mean.ply");
  EXPECT_THAT(refusal([&] { find_meshes({top() / "model"}); }),
              says("the folder of a model was not searched"));
}

TEST_F(FindFiles, ShapesBesideTheirTruthAreTheInput) {
  for (const char* name : {"demo/shapes/a.ply", "demo/truth/a.ply", "demo/c.ply", "truth/b.ply"}) file(name);
  const FoundFiles found = find_meshes({top()});
  EXPECT_THAT(names(found), ElementsAre("a", "b"));
  EXPECT_THAT(found.notes, ElementsAre(says("only shapes/ was searched")));
}

TEST_F(FindFiles, RepeatedNamesAreToldApartByTheNearestFolder) {
  for (const char* name : {"p1/ct/L1.ply", "p2/ct/L1.stl", "p2/ct/L2.ply"}) file(name);
  const FoundFiles found = find_meshes({top()});
  EXPECT_THAT(names(found), ElementsAre("p1_L1", "p2_L1", "p2_L2"))
      << "all files, not only the repeated ones";
  EXPECT_THAT(folders(found), ElementsAre("p1", "p2", "p2"));
  EXPECT_EQ(found.files[1].shown(), "p2_L1.stl");
}

TEST_F(FindFiles, FilesOfDifferentDepthsKeepToTheirOwnFolders) {
  for (const char* name : {"p1/ct/L1.ply", "p2/ct/L1.ply", "other/L3.ply"}) file(name);
  EXPECT_THAT(names(find_meshes({top()})), ElementsAre("other_L3", "p1_L1", "p2_L1"));
}

TEST_F(FindFiles, AllFoldersAreJoinedIfNoneSuffices) {
  for (const char* name : {"a/x/L1.ply", "a/y/L1.ply", "b/x/L1.ply"}) file(name);
  EXPECT_THAT(names(find_meshes({top()})), ElementsAre("a_x_L1", "a_y_L1", "b_x_L1"));
}

TEST_F(FindFiles, OneFileNamedTwiceIsOneFile) {
  const fs::path mesh = file("a/L1.ply");
  EXPECT_THAT(names(find_meshes({top(), mesh, top() / "a" / ".." / "a" / "L1.ply"})), ElementsAre("L1"));
}

TEST_F(FindFiles, OtherStructuresAmongMasksArePassedOverInOneNote) {
  for (const char* name :
       {"s1/ct.nii.gz", "s1/segmentations/vertebrae_L1.nii.gz", "s1/segmentations/liver.nii.gz",
        "s1/segmentations/rib_left_1.nii.gz", "s1/segmentations/sacrum.nii.gz", "s1/ring.ply"})
    file(name);
  const FoundFiles found = find_shape_files({top()});
  EXPECT_THAT(names(found), ElementsAre("ring", "sacrum", "vertebrae_L1"));
  EXPECT_THAT(found.notes, AllOf(SizeIs(2), Contains(AllOf(says("liver.nii.gz"), says("rib_left_1"))),
                                 Contains(says("ct.nii.gz"))));
}

TEST_F(FindFiles, LabelMapsWithoutMasksAmongThemAreAllTaken) {
  for (const char* name : {"liver.nii.gz", "spine_L1.nii.gz"}) file(name);
  EXPECT_THAT(names(find_label_maps({top()})), SizeIs(2));
}

TEST_F(FindFiles, NamesOfMasksComeFromTheirPatient) {
  for (const char* name : {"s1/segmentations/vertebrae_L1.nii.gz", "s2/segmentations/vertebrae_L1.nii.gz",
                           "s2/segmentations/p_L2.nii.gz"})
    file(name);
  const FoundFiles both = find_label_maps({top()});
  std::vector<std::string> stems;
  for (const ShapeFile& f : both.files) stems.push_back(f.label_map().mask_stem);
  EXPECT_THAT(stems, ::testing::UnorderedElementsAre("s1", "s2", "s2_p"));
  const FoundFiles one = find_label_maps({top() / "s1"});
  EXPECT_EQ(one.files.at(0).label_map().mask_stem, "s1");
  EXPECT_THAT(folders(one), ElementsAre(""));
}

TEST_F(FindFiles, AFileIsFoundByTheNameItHasInAnotherCohort) {
  for (const char* name : {"p1/L1.ply", "p2/L2.ply"}) file(name);
  const auto files = find_meshes({top()}).files;
  ASSERT_NE(file_named(files, "p1_L1"), nullptr);
  EXPECT_EQ(file_named(files, "p1_L1")->path.filename(), "L1.ply");
  EXPECT_EQ(file_named(files, "L2")->path.filename(), "L2.ply");
  EXPECT_EQ(file_named(files, "p1_L2"), nullptr);
}

TEST_F(FindFiles, WordsOfInputsTellTheFilesApart) {
  const std::string a = file("p1/L1.ply").string(), b = file("p2/L1.ply").string();
  EXPECT_THAT(words_of_inputs({a, b}, find_meshes), ElementsAre("p1_L1.ply", "p2_L1.ply"));
  EXPECT_THAT(words_of_inputs({a}, find_meshes), ElementsAre("L1.ply"));
  EXPECT_THAT(words_of_inputs({"gone/L1.ply"}, find_meshes), ElementsAre("L1.ply"));
}

}  // namespace
}  // namespace foramen
