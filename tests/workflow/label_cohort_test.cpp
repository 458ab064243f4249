// Label maps as inputs of a build, and the files of extract.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "foramen/topology/inspect_mesh.hpp"
#include "support/label_maps.hpp"
#include "support/meshes.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"
#include "workflow/run_build.hpp"
#include "workflow/run_extract.hpp"

namespace foramen {
namespace {

using namespace testing;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;

// Label 20 is a torus, 21 a ball, and 22 a torus that the upper border of the map cuts off.
LabelMap three_labels() {
  const auto label_at = [](const Vec3& p) {
    if (bumpy_torus(p + Vec3(46, 0, 0)) < 0) return 20;
    if (p.norm() < 14) return 21;
    if (bumpy_torus(p - Vec3(46, 0, 14)) < 0) return 22;
    return 0;
  };
  return labelled_lattice({80, 32, 20}, Vec3(2, 2, 2).asDiagonal(), label_at);
}

// Label 20, a torus with a tunnel of one voxel near the rim of its tube: genus 2.
LabelMap torus_with_tunnel() {
  const auto label_at = [](const Vec3& p) {
    const bool tunnel = std::abs(p.x() + 18) < 1 && std::abs(p.y()) < 1;
    return bumpy_torus(p, 16, 4) < 0 && !tunnel ? 20 : 0;
  };
  return labelled_lattice({51, 51, 27}, Vec3(1, 1, 1).asDiagonal(), label_at);
}

class LabelCohort : public ::testing::Test {
 protected:
  LabelCohort() { folder_.file("spine.nii.gz", packed(nifti_bytes(three_labels()))); }
  std::filesystem::path spine() const { return folder_.file("spine.nii.gz"); }
  static std::vector<std::string> stems(const auto& list) {
    std::vector<std::string> all;
    for (const auto& item : list) all.push_back(item.stem);
    return all;
  }
  TemporaryFolder folder_;
  RunContext ctx_{2};
};

TEST_F(LabelCohort, LabelsAndMeshesTogetherInOrderOfStem) {
  write_ply(folder_.file("spine.ply"), torus_soup(24, 12));
  write_ply(folder_.file("zebra.ply"), torus_soup(24, 12));
  const auto files = find_shape_files({folder_.path()}).files;
  ASSERT_EQ(files.size(), 3u);
  const Cohort cohort = read_cohort(files, LengthUnit::centimetre, ctx_);
  EXPECT_THAT(stems(cohort.shapes), ElementsAre("spine_L1")) << "the unit is that of the meshes alone";
  EXPECT_THAT(stems(cohort.left_out), ElementsAre("spine", "spine_L2", "spine_L3", "zebra"));
  EXPECT_EQ(cohort.shapes[0].label, 20);
  EXPECT_EQ(cohort.shapes[0].file_name, "spine.nii.gz");
  EXPECT_EQ(cohort.shapes[0].sha256, read_label_map(spine()).sha256);
  EXPECT_EQ(source_of(cohort.shapes[0]), "spine.nii.gz, label 20");
  EXPECT_THAT(cohort.left_out[1].reason, says("genus 0"));
  EXPECT_THAT(cohort.left_out[2].reason,
              AllOf(says("border of the label map (superior)"), offers({{RemedyKind::keep_cut}})));
}

TEST_F(LabelCohort, AFolderOfNeitherIsRefusedWithWhatWasLookedFor) {
  const TemporaryFolder empty;
  EXPECT_THAT(refusal([&] { find_shape_files({empty.path()}); }), says(".nii.gz"));
  EXPECT_THAT(refusal([&] { find_label_maps({empty.path()}); }), says("holds no label map"));
}

TEST_F(LabelCohort, EqualStemsAreRefused) {
  write_ply(folder_.file("spine_L1.ply"), torus_soup(24, 12));
  const auto files = find_shape_files({folder_.path()}).files;
  EXPECT_THAT(refusal([&] { read_cohort(files, LengthUnit::millimetre, ctx_); }),
              says("would both be named spine_L1"));
  folder_.file("spine.nrrd", "");
  EXPECT_THAT(refusal([&] { find_shape_files({folder_.path()}); }), says("same name without extension"));
}

TEST_F(LabelCohort, ASingleLabelMayBeMissingInOneMapButNotInAll) {
  folder_.file(
      "second.nii.gz",
      packed(nifti_bytes(labelled_lattice({30, 30, 12}, Vec3(2, 2, 2).asDiagonal(),
                                          [](const Vec3& p) { return bumpy_torus(p) < 0 ? 23 : 0; }))));
  const auto files = find_shape_files({folder_.path()}).files;
  const auto read = [&](const char* labels) {
    return read_cohort(files, LengthUnit::millimetre, ctx_, {.labels = LabelSelection::parse(labels)});
  };
  const Cohort cohort = read("20,23");
  EXPECT_THAT(stems(cohort.shapes), ElementsAre("second_L4", "spine_L1"));
  EXPECT_THAT(stems(cohort.left_out), ElementsAre("second_L1", "spine_L4"));
  EXPECT_THAT(refusal([&] { read("20-23,3"); }),
              AllOf(says("label 3: "), offers({{RemedyKind::choose_labels}})));
}

TEST_F(LabelCohort, AnUnreadableLabelMapIsLeftOutWhole) {
  folder_.file("torn.nii.gz", packed(nifti_bytes(three_labels())).substr(0, 200));
  const Cohort cohort = read_cohort(find_shape_files({folder_.path()}).files, LengthUnit::millimetre, ctx_);
  EXPECT_EQ(cohort.shapes.size(), 1u);
  EXPECT_THAT(stems(cohort.left_out), Contains("torn"));
}

TEST_F(LabelCohort, LabelOptionsWithoutALabelMapAreRefused) {
  write_ply(folder_.file("mesh.ply"), torus_soup(24, 12));
  BuildRequest request;
  request.inputs = {folder_.file("mesh.ply")};
  request.output = folder_.path() / "model";
  request.labels = LabelRequest{};
  EXPECT_THAT(refusal([&] { run_build(request, ctx_); }), says("no label map among the inputs"));
  EXPECT_FALSE(std::filesystem::exists(request.output));
}

TEST_F(LabelCohort, ExtractWritesSurfacesAndTheirRecord) {
  const std::filesystem::path out = folder_.path() / "out";
  const ExtractSummary summary =
      run_extract({.inputs = {spine()}, .output = out, .canonical_command = "c"}, ctx_);
  const auto record = nlohmann::json::parse(bytes_of(out / "extract.json"));
  EXPECT_EQ(record, nlohmann::json::parse(summary.json));
  const auto& file = record.at("files").at(0);
  EXPECT_EQ(file.at("sha256"), read_label_map(spine()).sha256);
  ASSERT_EQ(file.at("surfaces").size(), 2u);
  const auto &torus = file.at("surfaces").at(0), &ball = file.at("surfaces").at(1);
  EXPECT_EQ(torus.at("name"), "L1");
  EXPECT_EQ(torus.at("usable"), true);
  EXPECT_EQ(ball.at("usable"), false);
  EXPECT_EQ(ball.at("extraction").at("genus"), 0);
  EXPECT_THAT(summary.notes, Contains(says("spine_L2: not fit for a model: no hole")));
  EXPECT_EQ(file.at("refused").at(0).at("label"), 22);
  EXPECT_THAT(stems(summary.left_out), ElementsAre("spine_L3"));
  const MeshFile written = read_mesh(out / "spine_L1.ply");
  EXPECT_EQ(written.space, AnatomicalSpace::lps);
  EXPECT_EQ(inspect_mesh(written.soup).genus, 1);
  for (const Vec3& p : written.soup.points) EXPECT_LT(std::abs(bumpy_torus(p + Vec3(46, 0, 0))), 2.5);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 3) << "nothing else";
}

TEST_F(LabelCohort, ABuildRepairsTheHandlesThatVoxelsLeave) {
  const auto file = folder_.file("holed.nii.gz", packed(nifti_bytes(torus_with_tunnel())));
  const Cohort cohort = read_cohort({file}, LengthUnit::millimetre, ctx_);
  ASSERT_EQ(cohort.shapes.size(), 1u);
  EXPECT_EQ(inspect_mesh(cohort.shapes[0].mesh.soup()).genus, 1);
  ASSERT_TRUE(cohort.shapes[0].repair);
  EXPECT_THAT(foramen::summary(*cohort.shapes[0].repair), ::testing::HasSubstr("tunnel")) << "in words";
}

TEST_F(LabelCohort, ExtractRepairsWhatIsUnfitIfAsked) {
  const auto file = folder_.file("holed.nii.gz", packed(nifti_bytes(torus_with_tunnel())));
  const auto surface = [&](const std::optional<RepairOptions>& repair) {
    ExtractRequest request;
    request.inputs = {file};
    request.output = folder_.path() / "holed";
    request.repair = repair;
    const auto record = nlohmann::json::parse(run_extract(request, ctx_).json);
    EXPECT_EQ(record.at("files").at(0).at("surfaces").at(0).at("usable"), repair.has_value())
        << record.at("notes");
    return inspect_mesh(read_mesh(request.output / "holed_L1.ply").soup);
  };
  EXPECT_EQ(surface(std::nullopt).genus, 2);
  EXPECT_EQ(surface(RepairOptions()).genus, 1);
}

TEST_F(LabelCohort, ExtractRefusesAMissingSingleLabelBeforeItWrites) {
  const std::filesystem::path out = folder_.path() / "out";
  const auto extract = [&](const char* labels) {
    return refusal([&] {
      run_extract({.inputs = {spine()},
                   .output = out,
                   .labels = {.labels = LabelSelection::parse(labels)},
                   .repair = std::nullopt,
                   .canonical_command = ""},
                  ctx_);
    });
  };
  EXPECT_THAT(extract("20-22,3"), AllOf(says("label 3: the label map has no such label; it holds 20-22"),
                                        offers({{RemedyKind::choose_labels}})));
  EXPECT_THAT(extract("22"), AllOf(says("no label could be extracted\n  left out spine.nii.gz, label 22: "),
                                   offers({{RemedyKind::keep_cut}})));
  EXPECT_FALSE(std::filesystem::exists(out));
}

}  // namespace
}  // namespace foramen
