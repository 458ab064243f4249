#include "workflow/evaluate_folder.hpp"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "modelfiles/corresponding_folder.hpp"
#include "modelfiles/metrics_file.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

// A cohort as files: corresponding meshes in meshes/, and the original surfaces in surfaces/.
class EvaluateFolder : public ::testing::Test {
 protected:
  void SetUp() override {
    cohort_ = testing::torus_cohort({.shapes = 4});
    write(at("meshes"), cohort_.corresponding);
    fs::create_directories(at("surfaces"));
    for (std::size_t i = 0; i < 4; ++i)
      write_ply(at("surfaces") / (cohort_.names[i] + ".ply"), cohort_.inputs[i].soup());
  }
  fs::path at(const std::string& name) const { return folder_.file(name); }
  void write(const fs::path& folder, const std::vector<std::vector<Vec3>>& shapes) const {
    fs::create_directories(folder);
    for (std::size_t i = 0; i < shapes.size(); ++i)
      write_ply(folder / (cohort_.names[i] + ".ply"), {shapes[i], cohort_.triangles});
  }
  EvaluateFolderRequest request() const {
    EvaluateFolderRequest request;
    request.corresponding = at("meshes");
    request.options = {.draws = 4, .samples = 200, .specificity_samples = 50};
    return request;
  }
  static EvaluatedFolder evaluated(const EvaluateFolderRequest& request) {
    return evaluate_folder(request, RunContext(2));
  }
  static Message refused(const EvaluateFolderRequest& request) {
    return testing::refusal([&] { evaluated(request); });
  }
  const CorrespondingCohort& cohort() const { return cohort_; }

 private:
  testing::TemporaryFolder folder_;
  CorrespondingCohort cohort_;
};

TEST_F(EvaluateFolder, IsEvaluateModelOfWhatTheFilesHold) {
  EvaluateFolderRequest with_surfaces = request();
  with_surfaces.shapes = at("surfaces");
  const EvaluatedFolder found = evaluated(with_surfaces);
  CorrespondingCohort same = cohort();
  same.subjects.clear();
  same.corresponding = read_corresponding(at("meshes")).shapes;
  for (std::size_t i = 0; i < 4; ++i)
    same.inputs[i] = build_mesh(read_mesh(at("surfaces") / (same.names[i] + ".ply")).soup);
  EXPECT_EQ(found.json, metrics_json(evaluate(same, with_surfaces.options, RunContext(1))));
  EXPECT_EQ(found.evaluation.names, cohort().names);
  EXPECT_GT(found.evaluation.representation.mean_surface.mean, 0.01);
  EXPECT_THAT(found.text, HasSubstr("4 shapes, 160 landmarks"));
}

TEST_F(EvaluateFolder, WithoutSurfacesTheMeshesStandForThemselves) {
  const Evaluation e = evaluated(request()).evaluation;
  EXPECT_LT(e.representation.hausdorff.mean, 1e-9);
  EXPECT_FALSE(e.truth);
  EXPECT_FALSE(e.leave_subject_out);
}

TEST_F(EvaluateFolder, AModelsFolderStandsForItsCorrespondingMeshes) {
  fs::create_directories(at("model"));
  fs::rename(at("meshes"), at("model") / "corresponding");
  EvaluateFolderRequest of_model = request();
  of_model.corresponding = at("model");
  EXPECT_EQ(evaluated(of_model).evaluation.names, cohort().names);
}

TEST_F(EvaluateFolder, SubjectsAreReadFromTheNames) {
  EvaluateFolderRequest by_subject = request();
  by_subject.subject_pattern = "(patient[0-9]+)_.*";
  const Evaluation e = evaluated(by_subject).evaluation;
  EXPECT_EQ(e.subjects, cohort().subjects);
  ASSERT_TRUE(e.leave_subject_out);
  EXPECT_EQ(e.leave_subject_out->groups, 2);
}

TEST_F(EvaluateFolder, SubjectsOfAModelAreThoseOfItsMetrics) {
  EvaluateFolderRequest by_subject = request();
  by_subject.subject_pattern = "(patient[0-9]+)_.*";
  by_subject.output = at("model");
  evaluated(by_subject);
  fs::rename(at("meshes"), at("model") / "corresponding");
  EvaluateFolderRequest of_model = request();
  of_model.corresponding = at("model");
  EXPECT_EQ(evaluated(of_model).evaluation.subjects, cohort().subjects);
}

TEST_F(EvaluateFolder, FoldersThatTellFilesApartAreTheSubjects) {
  for (std::size_t i = 0; i < 4; ++i) {
    const fs::path folder = at("people") / ("p" + std::to_string(i / 2));
    fs::create_directories(folder);
    write_ply(folder / ("L" + std::to_string(1 + i % 2) + ".ply"),
              {cohort().corresponding[i], cohort().triangles});
  }
  EvaluateFolderRequest of_people = request();
  of_people.corresponding = at("people");
  const Evaluation e = evaluated(of_people).evaluation;
  EXPECT_THAT(e.names, ::testing::ElementsAre("p0_L1", "p0_L2", "p1_L1", "p1_L2"));
  EXPECT_THAT(e.subjects, ::testing::ElementsAre("p0", "p0", "p1", "p1"));
}

TEST_F(EvaluateFolder, NotesOfTheSearchAndOfTheFilesArePassedOn) {
  fs::create_directories(at("surfaces") / ".hidden");
  std::ofstream(at("surfaces") / (cohort().names[1] + ".ply"), std::ios::app) << "\n more";
  EvaluateFolderRequest with_surfaces = request();
  with_surfaces.shapes = at("surfaces");
  const auto notes = evaluated(with_surfaces).notes;
  EXPECT_THAT(notes, ::testing::Contains(::testing::Field(&Message::text, HasSubstr("hidden folders"))));
  EXPECT_THAT(notes, ::testing::Contains(::testing::Field(&Message::text, HasSubstr(cohort().names[1]))));
}

TEST_F(EvaluateFolder, ALabelMapInPlaceOfSurfacesIsNamed) {
  EvaluateFolderRequest of_label_map = request();
  of_label_map.shapes = at("map.nii.gz");
  EXPECT_THAT(refused(of_label_map),
              AllOf(testing::says("is a label map"), testing::offers({{RemedyKind::extract_surfaces}})));
}

TEST_F(EvaluateFolder, MetricsAreWrittenWhereTheyAreWanted) {
  EvaluateFolderRequest written = request();
  written.output = at("new") / "metrics";
  const EvaluatedFolder found = evaluated(written);
  EXPECT_EQ(read_metrics(written.output).total_variance, found.evaluation.total_variance);
  EXPECT_TRUE(fs::exists(written.output / "metrics.csv"));
}

TEST_F(EvaluateFolder, TheTruthHasNoErrorAndItsLandmarksAreWritten) {
  EvaluateFolderRequest with_truth = request();
  with_truth.truth = at("meshes");
  with_truth.true_landmarks = at("true");
  const Evaluation e = evaluated(with_truth).evaluation;
  ASSERT_TRUE(e.truth);
  EXPECT_LT(e.truth->error.max, 1e-4) << "files are of single precision";
  const CorrespondingFolder meshes = read_corresponding(at("meshes")), found = read_corresponding(at("true"));
  EXPECT_EQ(found.names, meshes.names);
  for (std::size_t s = 0; s < 4; ++s)
    for (std::size_t i = 0; i < 160; ++i) EXPECT_LT((found.shapes[s][i] - meshes.shapes[s][i]).norm(), 1e-4);
}

TEST_F(EvaluateFolder, MarksAndRegionsAreThoseOfTheFiles) {
  // Marks at a landmark, and slices of the torus as regions, both moved by one step on the last shape.
  std::string table = "shape,landmark,x,y,z\n";
  double step = 0;
  fs::create_directories(at("labels"));
  for (std::size_t s = 0; s < 4; ++s) {
    const std::size_t landmark = s == 3 ? 33 : 32, first = s == 3 ? 8 : 0;
    const Vec3& p = cohort().corresponding[s][landmark];
    table += cohort().names[s] + ",tip," + std::to_string(p.x()) + "," + std::to_string(p.y()) + "," +
             std::to_string(p.z()) + "\n";
    std::ofstream labels(at("labels") / (cohort().names[s] + ".txt"));
    for (std::size_t v = 0; v < 160; ++v) labels << (v >= first && v < first + 32 ? "2\n" : "0\n");
    for (const std::size_t to : {0u, 1u, 2u})
      if (s == 3) step += (cohort().corresponding[to][33] - cohort().corresponding[to][32]).norm();
    if (s != 3) step += (cohort().corresponding[3][33] - cohort().corresponding[3][32]).norm();
  }
  std::ofstream(at("marks.csv")) << table;
  EvaluateFolderRequest marked = request();
  marked.marks = {at("marks.csv")};
  marked.regions = {at("labels")};
  marked.output = at("metrics");
  const EvaluatedFolder found = evaluated(marked);
  ASSERT_TRUE(found.evaluation.marks && found.evaluation.regions);
  EXPECT_NEAR(found.evaluation.marks->points->error.mean, step / 12, 1e-4);
  EXPECT_EQ(found.evaluation.regions->by_region.at(0).region, "2");
  EXPECT_LT(found.evaluation.regions->dice.mean, 0.95);
  EXPECT_GT(found.evaluation.regions->dice.mean, 0.8);  // half of the pairs at 3 of 4 slices
  EXPECT_THAT(found.text, AllOf(HasSubstr("marks, points: mean "), HasSubstr("regions: mean Dice "),
                                HasSubstr("Points that people marked")));
  EXPECT_EQ(read_metrics(marked.output).marks->points->error.mean,
            found.evaluation.marks->points->error.mean);
  EXPECT_TRUE(found.notes.empty());
}

TEST_F(EvaluateFolder, DoubtfulMarksAreNoted) {
  std::string table = "shape,landmark,x,y,z\n";
  for (std::size_t s = 0; s < 4; ++s) {
    const Vec3 p = cohort().corresponding[s][32] * (s == 1 ? -1 : 1);
    table += cohort().names[s] + ",tip," + std::to_string(p.x()) + "," + std::to_string(p.y()) + "," +
             std::to_string(p.z()) + "\n";
  }
  std::ofstream(at("marks.csv")) << table;
  EvaluateFolderRequest marked = request();
  marked.marks = {at("marks.csv")};
  EXPECT_THAT(evaluated(marked).notes,
              ::testing::ElementsAre(testing::says("the marks of " + cohort().names[1] + " lie ")));
}

TEST_F(EvaluateFolder, NamesWhatIsMissing) {
  EvaluateFolderRequest without_truth = request();
  without_truth.true_landmarks = at("true");
  EXPECT_THAT(refused(without_truth),
              AllOf(testing::says("true correspondence"), testing::offers({{RemedyKind::give_truth}})));
  EXPECT_FALSE(fs::exists(at("true")));
  EvaluateFolderRequest missing = request();
  missing.shapes = at("surfaces");
  fs::remove(at("surfaces") / (cohort().names[2] + ".ply"));
  EXPECT_THAT(refused(missing), testing::says(cohort().names[2]));
  EvaluateFolderRequest other = request();
  write_ply(at("meshes") / (cohort().names[1] + ".ply"), testing::torus_soup(6, 5));
  EXPECT_THAT(refused(other), testing::says(cohort().names[1]));
}

}  // namespace
}  // namespace foramen
