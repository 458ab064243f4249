// What is done with the folder of a model, from files to files. The program's tests cover project_files().

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/io/statismo_file.hpp"
#include "io/table_file.hpp"
#include "support/temporary_folder.hpp"
#include "workflow/complete_file.hpp"
#include "workflow/measure_model.hpp"
#include "workflow/read_family.hpp"
#include "workflow/reconstruct_shapes.hpp"
#include "workflow/sample_model.hpp"
#include "workflow/write_mode_shapes.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ModelVerbs : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    BuildOptions options = testing::small();
    options.correspondence.method = Method::icp;  // the cheapest
    options.landmarks.count = 200;
    write_model_files(folder_->file("model"), testing::family_build(options), "foramen build", 1);
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path model() { return folder_->file("model"); }
  static fs::path file(const std::string& name) { return folder_->file(name); }

 private:
  static inline testing::TemporaryFolder* folder_ = nullptr;
};

TEST_F(ModelVerbs, ASampleIsTheSameOnAnyNumberOfThreads) {
  sample_model({.model = model(), .output = file("one"), .count = 5, .seed = 3}, RunContext(1));
  sample_model({.model = model(), .output = file("two"), .count = 5, .seed = 3}, RunContext(2));
  for (int i = 1; i <= 5; ++i) {
    const std::string name = "sample000" + std::to_string(i) + ".ply";
    EXPECT_TRUE(testing::bytes_of(file("one") / name) == testing::bytes_of(file("two") / name)) << name;
  }
  EXPECT_FALSE(testing::bytes_of(file("one/sample0001.ply")) ==
               testing::bytes_of(file("one/sample0002.ply")));
}

TEST_F(ModelVerbs, ModesAreMeshesOnBothSidesOfTheMean) {
  const ModeShapesSummary summary = write_mode_shapes({.model = model(), .output = file("modes"), .sd = 3});
  EXPECT_EQ(summary.files, 2 * read_statismo(model() / "model.h5").variance.size());
  EXPECT_THAT(summary.notes, IsEmpty());
  const auto mean = read_mesh(model() / "mean.ply").soup.points;
  const auto minus = read_mesh(file("modes/mode01_minus3sd.ply")).soup.points;
  const auto plus = read_mesh(file("modes/mode01_plus3sd.ply")).soup.points;
  const auto plus_two = read_mesh(model() / "modes/mode01_plus2sd.ply").soup.points;
  ASSERT_EQ(plus.size(), mean.size());
  for (std::size_t i = 0; i < mean.size(); ++i) {
    EXPECT_LT(((minus[i] + plus[i]) / 2 - mean[i]).norm(), 1e-4);  // files round
    EXPECT_LT((plus[i] - mean[i] - 1.5 * (plus_two[i] - mean[i])).norm(), 1e-4);
  }
}

TEST_F(ModelVerbs, ShapesOfScoresAreThoseOfTheModel) {
  std::ofstream(file("scores.csv")) << "shape,mode1\nmean,0\nfar,2\n";
  EXPECT_EQ(reconstruct_shapes({model(), file("scores.csv"), file("shapes")}, RunContext(1)), 2);
  const auto far = read_mesh(file("shapes/far.ply")).soup.points;
  const auto plus_two = read_mesh(model() / "modes/mode01_plus2sd.ply").soup.points;
  ASSERT_EQ(far.size(), plus_two.size());
  for (std::size_t i = 0; i < far.size(); ++i)
    EXPECT_LT((far[i] - plus_two[i]).norm(), 1e-4);  // model.h5 rounds
  std::ofstream(file("scores.csv")) << "shape,mode1\na,inf\n";
  EXPECT_THROW(reconstruct_shapes({model(), file("scores.csv"), file("shapes")}, RunContext(1)), IoError);
}

TEST_F(ModelVerbs, MeasuresOfAModelAreATableOfItsShapes) {
  std::ofstream(file("measures.json")) << R"({"points": {"a": 0, "b": 1}, "distances": {"d": ["a", "b"]}})";
  const MeasureSummary summary = measure_model(
      {.model = model(), .definitions = file("measures.json"), .output = file("m.csv")}, RunContext(1));
  EXPECT_EQ(summary.shapes, 4u);
  const Table table = read_csv(file("m.csv"));
  EXPECT_EQ(table.header, summary.columns);
  EXPECT_THAT(table.header,
              ElementsAre("shape", "a_x_mm", "a_y_mm", "a_z_mm", "b_x_mm", "b_y_mm", "b_z_mm", "d_mm"));
  const auto points = read_mesh(model() / "corresponding/s2.ply").soup.points;
  EXPECT_EQ(table.rows[2][0], "s2");
  EXPECT_EQ(parse_number(table.rows[2][7]), (points[0] - points[1]).norm());
}

TEST_F(ModelVerbs, ACompletionIsAMeshAModelAndARecord) {
  const fs::path part = model() / "corresponding/s1.ply";
  const CompleteSummary summary =
      complete_file({.model = model(), .surface = part, .output = file("whole")}, RunContext(2));
  EXPECT_EQ(testing::bytes_of(file("whole/complete.json")), summary.json + "\n");
  const auto record = nlohmann::json::parse(summary.json);
  EXPECT_EQ(record.at("surface"), "s1.ply");
  EXPECT_LT(record.at("distance_mm").get<double>(), 1.0);
  EXPECT_THAT(summary.text, HasSubstr("completed.ply: mean distance to the part"));
  EXPECT_EQ(read_statismo(file("whole/posterior.h5")).triangles, read_mesh(part).soup.triangles);
  EXPECT_EQ(read_mesh(file("whole/completed.ply")).soup.triangles, read_mesh(part).soup.triangles);
  std::ofstream(file("none.ply")) << "no mesh";
  EXPECT_THROW(
      complete_file({.model = model(), .surface = file("none.ply"), .output = file("x")}, RunContext(1)),
      IoError);
  EXPECT_FALSE(fs::exists(file("x")));
}

}  // namespace
}  // namespace foramen
