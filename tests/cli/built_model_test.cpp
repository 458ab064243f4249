// The files that a build writes, and the commands that read them.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of;
using testing::files_of;
using ::testing::HasSubstr;
using testing::Outcome;
using testing::run;

// A small synthetic cohort and its model, built once for all tests on one thread.
class BuiltModel : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    ASSERT_EQ(run("synth -n 3 --seed 7 --vertices 2500 -o " + at("synth")).code, 0);
    const Outcome built = build("--threads 1", at("model"));
    ASSERT_EQ(built.code, 0) << built.output;
    fs::copy(at("model"), at("other"), fs::copy_options::recursive);
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::string at(const std::string& name) { return (folder_->path() / name).string(); }
  static std::string shapes() { return at("synth") + "/shapes"; }
  static Outcome build(const std::string& more, const std::string& model) {
    return run("build --landmarks 400 --samples 30 --quiet " + more + " " + shapes() + " -o " + model);
  }

 private:
  static inline testing::TemporaryFolder* folder_ = nullptr;
};

void expect_same_files(const std::map<std::string, std::string>& files,
                       const std::map<std::string, std::string>& expected) {
  EXPECT_EQ(files.size(), expected.size());
  for (const auto& [name, bytes] : expected) {
    ASSERT_TRUE(files.contains(name)) << name;
    EXPECT_TRUE(files.at(name) == bytes) << name << " differs";
  }
}

TEST_F(BuiltModel, HasEveryFile) {
  const auto files = files_of(at("model"));
  for (const char* name : {"model.h5", "mean.ply", "corresponding/synth001.ply", "corresponding/synth003.ply",
                           "modes/mode01_minus2sd.ply", "modes/mode01_plus2sd.ply", "atlas.h5", "scores.csv",
                           "metrics.json", "metrics.csv", "error_maps.h5", "report.html"})
    EXPECT_TRUE(files.contains(name)) << name;
}

TEST_F(BuiltModel, RecordHasEveryShapeWithoutAFlippedTriangle) {
  const auto record = nlohmann::json::parse(bytes_of(at("model") + "/run.json"));
  EXPECT_EQ(record.at("shapes").size(), 3u);
  for (const auto& shape : record.at("shapes")) EXPECT_EQ(shape.at("certificate").at("flipped"), 0);
}

// The build runs twice, to detect results that depend on the order in which two threads finish.
TEST_F(BuiltModel, TwoThreadsWriteTheSameBytesInEveryRun) {
  for (const char* name : {"two", "again"}) {
    SCOPED_TRACE(name);
    ASSERT_EQ(build("--threads 2", at(name)).code, 0);
    expect_same_files(files_of(at(name)), files_of(at("model")));
  }
}

TEST_F(BuiltModel, ReportWritesThePageThatTheBuildWrote) {
  const std::string page = at("other") + "/report.html";
  fs::remove(page);
  ASSERT_EQ(run("report " + at("other")).code, 0);
  EXPECT_TRUE(bytes_of(page) == bytes_of(at("model") + "/report.html"));
}

TEST_F(BuiltModel, ReportPlainNamesItsBaselineAndSaysWhyItIsPlain) {
  const std::string page = at("plain.html");
  const Outcome reported =
      run("report --plain --baseline " + at("other") + " " + at("model") + " -o " + page);
  ASSERT_EQ(reported.code, 0) << reported.output;
  EXPECT_THAT(reported.output, HasSubstr("plain page, since"));
  EXPECT_THAT(bytes_of(page), HasSubstr("This is the plain page"));
  EXPECT_THAT(bytes_of(page), HasSubstr("baseline: other"));
}

TEST_F(BuiltModel, SampleWritesAsManyShapesAsAreAskedFor) {
  EXPECT_EQ(run("sample " + at("model") + " -n 3 -o " + at("samples")).code, 0);
  EXPECT_EQ(files_of(at("samples")).size(), 3u);
}

TEST_F(BuiltModel, ModesAreWrittenAtTheDeviationsAskedFor) {
  EXPECT_EQ(run("modes " + at("model") + " --sd 3 -o " + at("modes")).code, 0);
  EXPECT_TRUE(fs::exists(at("modes") + "/mode01_plus3sd.ply"));
  EXPECT_TRUE(fs::exists(at("modes") + "/mode01_minus3sd.ply"));
}

TEST_F(BuiltModel, EvaluateTakesTheModelItsShapesAndTheTruth) {
  const Outcome evaluated = run("evaluate " + at("model") + " --samples 10 --shapes " + shapes() +
                                " --truth " + at("synth") + "/truth");
  EXPECT_EQ(evaluated.code, 0) << evaluated.output;
  EXPECT_THAT(evaluated.output, HasSubstr("3 shapes, 400 landmarks"));
  EXPECT_THAT(evaluated.output, HasSubstr("truth error: mean"));
}

TEST_F(BuiltModel, EvaluateTakesMarksAndRegionsAndCompareTestsThem) {
  std::string table = "shape,landmark,x,y,z\n", labels;
  for (int v = 0; v < 400; ++v) labels += v < 200 ? "1\n" : "2\n";
  fs::create_directories(at("labels"));
  for (const std::string name : {"synth001", "synth002", "synth003"}) {
    table += name + ",middle,0,0,0\n";
    std::ofstream(at("labels/" + name + ".txt")) << labels;
  }
  std::ofstream(at("marks.csv")) << table;
  const std::string evaluate = "evaluate --samples 2 " + at("model") + " --marks " + at("marks.csv") +
                               " --regions " + at("labels") + " -o ";
  const Outcome evaluated = run(evaluate + at("marked"));
  ASSERT_EQ(evaluated.code, 0) << evaluated.output;
  EXPECT_THAT(evaluated.output, HasSubstr("marks, points: mean "));
  EXPECT_THAT(evaluated.output, HasSubstr("regions: mean Dice 1.0000"));  // the labels are of the landmarks
  fs::copy(at("marked"), at("marked_again"));
  const Outcome compared = run("compare " + at("marked") + " " + at("marked_again"));
  EXPECT_EQ(compared.code, 0) << compared.output;
  EXPECT_THAT(compared.output, HasSubstr("marked_again minus marked: Marks, points"));
  EXPECT_THAT(compared.output, HasSubstr("Regions that people marked"));
  const Outcome refused = run("evaluate " + at("model") + " --marks " + at("nowhere.csv"));
  EXPECT_NE(refused.code, 0);
  EXPECT_THAT(refused.output, HasSubstr("nowhere.csv: there is no such file"));
}

TEST_F(BuiltModel, CompareWritesTablesAndCharts) {
  const Outcome compared = run("compare " + at("model") + " " + at("other") + " -o " + at("compare"));
  EXPECT_EQ(compared.code, 0) << compared.output;
  EXPECT_THAT(compared.output, HasSubstr("Specificity"));
  EXPECT_TRUE(fs::exists(at("compare") + "/specificity.svg"));
}

TEST_F(BuiltModel, RenderWritesTheCurvesThatItLists) {
  const Outcome rendered = run("render --only-curves --json " + at("model") + " --baseline " + at("other") +
                               " -o " + at("curves"));
  ASSERT_EQ(rendered.code, 0) << rendered.output;
  const auto written = nlohmann::json::parse(rendered.output).at("files");
  EXPECT_TRUE(written.contains("specificity.pdf"));
  EXPECT_EQ(files_of(at("curves")).size(), written.size());
}

}  // namespace
}  // namespace foramen
