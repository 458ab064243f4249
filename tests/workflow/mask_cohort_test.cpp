// Folders of masks, one vertebra a file, and of layered segmentations, as inputs of a build and of extract.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fstream>

#include "support/label_maps.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"
#include "workflow/run_extract.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using namespace testing;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class MaskCohort : public ::testing::Test {
 protected:
  // A patient with masks of L1 and L2, an empty one of C1 and one of another structure.
  void patient(const std::string& name) {
    mask(name + "/segmentations/vertebrae_L1.nii.gz", 1);
    mask(name + "/segmentations/vertebrae_L2.nii.gz", 1);
    mask(name + "/segmentations/vertebrae_C1.nii.gz", 0);
    mask(name + "/segmentations/liver.nii.gz", 1);
  }
  fs::path mask(const std::string& path, int label) {
    const LabelMap map = labelled_lattice({28, 28, 12}, Vec3(2, 2, 2).asDiagonal(),
                                          [&](const Vec3& p) { return bumpy_torus(p) < 0 ? label : 0; });
    fs::create_directories((folder_.path() / path).parent_path());
    return folder_.file(path, packed(nifti_bytes(map)));
  }
  Cohort cohort(const std::vector<fs::path>& inputs, const LabelRequest& request = {}) {
    return read_cohort(find_shape_files(inputs).files, LengthUnit::millimetre, ctx_, request);
  }
  static std::vector<std::string> stems(const auto& list) {
    std::vector<std::string> all;
    for (const auto& item : list) all.push_back(item.stem);
    return all;
  }
  TemporaryFolder folder_;
  RunContext ctx_{2};
};

TEST_F(MaskCohort, PatientsAreFoldersAndLevelsAreFiles) {
  patient("s0001");
  patient("s0002");
  const Cohort read = cohort({folder_.path()});
  EXPECT_THAT(stems(read.shapes), ElementsAre("s0001_L1", "s0001_L2", "s0002_L1", "s0002_L2"));
  EXPECT_THAT(read.left_out, IsEmpty()) << "an empty mask is no shape that is lost";
  EXPECT_EQ(read.shapes[0].folder, "s0001");
  EXPECT_EQ(read.shapes[0].names_from, "the file's name");
  EXPECT_THAT(read.notes, ElementsAre(AllOf(says("2 masks are empty"), says("s0001/vertebrae_C1.nii.gz"))));
}

TEST_F(MaskCohort, MasksAreSelectedByTheNumbersOfTheirLevels) {
  patient("s0001");
  const LabelRequest l2{.labels = LabelSelection::parse("21-24")};
  EXPECT_THAT(stems(cohort({folder_.path()}, l2).shapes), ElementsAre("s0001_L2"));
  const LabelRequest single{.labels = LabelSelection::parse("31"),
                            .numbering = LabelNumbering::totalsegmentator};
  const Cohort read = cohort({folder_.path()}, single);
  EXPECT_THAT(stems(read.shapes), ElementsAre("s0001_L1"));
  EXPECT_THAT(read.notes, Contains(says("another level than those asked for")));
}

TEST_F(MaskCohort, ExtractWritesAMeshAVertebraAndRecordsWhatNamedIt) {
  patient("s0001");
  const fs::path out = folder_.path() / "out";
  const ExtractSummary summary =
      run_extract({.inputs = {folder_.path() / "s0001"}, .output = out, .canonical_command = "c"}, ctx_);
  EXPECT_TRUE(fs::exists(out / "s0001_L1.ply") && fs::exists(out / "s0001_L2.ply"));
  EXPECT_THAT(summary.left_out, IsEmpty());
  EXPECT_THAT(summary.notes, AllOf(Contains(says("liver.nii.gz")), Contains(says("1 mask is empty"))));
  const auto record = nlohmann::json::parse(summary.json);
  EXPECT_EQ(record.at("files").at(0).at("passed_over"), "empty");
  EXPECT_EQ(record.at("files").at(1).at("names_from"), "the file's name");
}

TEST_F(MaskCohort, NothingButEmptyMasksIsRefusedWithTheReason) {
  const auto file = mask("s0001/vertebrae_L1.nii.gz", 0);
  EXPECT_THAT(refusal([&] {
                run_extract({.inputs = {file}, .output = folder_.path() / "out", .canonical_command = "c"},
                            ctx_);
              }),
              says("1 mask is empty"));
}

TEST_F(MaskCohort, AnAssumedNumberingIsSaidOnceAndRecorded) {
  mask("a.nii.gz", 20);
  mask("b.nii.gz", 21);
  const Cohort read = cohort({folder_.path()});
  EXPECT_EQ(read.shapes.at(0).names_from, "verse, assumed");
  EXPECT_THAT(read.notes, ElementsAre(AllOf(says("VerSe"), says("a.nii.gz, b.nii.gz"),
                                            offers({{RemedyKind::name_labels}}))));
  const Cohort said = cohort({folder_.path()}, {.numbering = LabelNumbering::verse});
  EXPECT_EQ(said.shapes.at(0).names_from, "verse");
  EXPECT_THAT(said.notes, IsEmpty());
}

TEST_F(MaskCohort, LabelMapsOfOneNameAreToldApart) {
  mask("p1/spine.nii.gz", 20);
  mask("p2/spine.nii.gz", 20);
  const Cohort read = cohort({folder_.path()});
  EXPECT_THAT(stems(read.shapes), ElementsAre("p1_spine_L1", "p2_spine_L1"));
  EXPECT_EQ(source_of(read.shapes[1]), "p2_spine.nii.gz, label 20");
}

TEST_F(MaskCohort, EachLayerOfASegmentationGivesItsSegments) {
  const LabelMap map = labelled_lattice({28, 28, 12}, Vec3(2, 2, 2).asDiagonal(),
                                        [](const Vec3& p) { return bumpy_torus(p) < 0 ? 1 : 0; });
  std::string header = nrrd_header(map);
  const auto put = [&](const std::string& before, const std::string& more) {
    header.insert(header.find(before) + before.size(), more);
  };
  header.replace(header.find("dimension: 3"), 12, "dimension: 4");
  put("sizes: ", "2 ");
  put("space directions: ", "none ");
  std::string voxels;
  for (const std::uint16_t label : map.labels)
    for (int layer = 0; layer < 2; ++layer) append_value(voxels, label);
  const auto file = folder_.file("p.seg.nrrd", header +
                                                   "Segment0_Name:=L1 vertebra\nSegment0_LabelValue:=1\n"
                                                   "Segment0_Layer:=0\nSegment1_Name:=L2 vertebra\n"
                                                   "Segment1_LabelValue:=1\nSegment1_Layer:=1\n"
                                                   "encoding: gzip\n\n" +
                                                   packed(voxels));
  const LabelSurfaces found = extract_labels(file, {.labels = LabelSelection::parse("1")}, ctx_);
  EXPECT_THAT(stems(found.surfaces), ElementsAre("p_L1", "p_L2"));
  EXPECT_EQ(found.names_from, "the names in the file");
}

}  // namespace
}  // namespace foramen
