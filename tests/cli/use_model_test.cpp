// The commands that use a model: project, reconstruct, complete, measure.

#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/io/mesh_file.hpp"
#include "foramen/model/procrustes.hpp"
#include "io/table_file.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using testing::bytes_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::Outcome;
using testing::run;

// A small model of synthetic shapes, made once for all tests. The fifth shape is not in the model.
class UseModel : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    ASSERT_EQ(run("synth -n 5 --seed 7 --vertices 2500 -o " + at("synth")).code, 0);
    fs::rename(at("synth") + "/shapes/synth005.ply", at("unseen.ply"));
    const Outcome built =
        run("build --landmarks 400 --samples 5 --quiet " + at("synth") + "/shapes -o " + at("model"));
    ASSERT_EQ(built.code, 0) << built.output;
  }
  static void TearDownTestSuite() { delete folder_; }
  static std::string at(const std::string& name) { return (folder_->path() / name).string(); }

 private:
  static inline testing::TemporaryFolder* folder_ = nullptr;
};

double largest_difference(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, (a[i] - b[i]).norm());
  return largest;
}

TEST_F(UseModel, ReconstructOfTheModelsScoresIsItsShapes) {
  const Outcome made =
      run("reconstruct " + at("model") + " " + at("model/scores.csv") + " -o " + at("again"));
  ASSERT_EQ(made.code, 0) << made.output;
  for (const char* name : {"/synth001.ply", "/synth004.ply"}) {
    const TriangleSoup again = read_mesh(at("again") + name).soup;
    std::vector<Vec3> own = read_mesh(at("model/corresponding") + name).soup.points;
    const SimilarityTransform motion = fit_similarity(own, again.points, ScaleMode::keep);
    for (Vec3& p : own) p = motion(p);
    EXPECT_LT(largest_difference(own, again.points), 1e-3);
    EXPECT_EQ(again.triangles, read_mesh(at("model/mean.ply")).soup.triangles);
  }
}

TEST_F(UseModel, ReconstructTakesAnyModesAndRefusesWhatIsNone) {
  const auto reconstruct = [&](const std::string& csv) {
    std::ofstream(at("s.csv")) << csv;
    return run("reconstruct " + at("model") + " " + at("s.csv") + " -o " + at("some"));
  };
  ASSERT_EQ(reconstruct("shape,mode2\nplus,2\nzero,0\n").code, 0);
  const auto points = [&](const std::string& file) { return read_mesh(at(file)).soup.points; };
  EXPECT_LT(largest_difference(points("some/plus.ply"), points("model/modes/mode02_plus2sd.ply")), 1e-4);
  EXPECT_LT(largest_difference(points("some/zero.ply"), points("model/mean.ply")), 1e-4);
  EXPECT_THAT(reconstruct("shape,mode99\na,1\n").output, HasSubstr("mode99"));
  EXPECT_THAT(reconstruct("name,mode1\na,1\n").output, HasSubstr("\"shape\""));
  EXPECT_THAT(reconstruct("shape,mode1\na/b,1\n").output, HasSubstr("a/b"));
  EXPECT_THAT(reconstruct("shape,mode1\na,1\na,2\n").output, HasSubstr("name"));
  EXPECT_EQ(reconstruct("shape,mode1\na,x\n").code, 1);
}

TEST_F(UseModel, ProjectGivesLandmarksScoresAndResidual) {
  const std::string surfaces = at("unseen.ply") + " " + at("synth/shapes/synth002.ply");
  const Outcome projected = run("project --json " + at("model") + " " + surfaces + " -o " + at("projected"));
  ASSERT_EQ(projected.code, 0) << projected.output;
  const auto shapes = nlohmann::json::parse(bytes_of(at("projected/project.json"))).at("shapes");
  ASSERT_EQ(shapes.size(), 2u);
  // In order of stem: a training shape, which is also left out for a second distance, and a new shape.
  EXPECT_EQ(shapes[0].at("shape"), "synth002");
  EXPECT_EQ(shapes[0].at("left_out").at(0), "synth002");
  EXPECT_GT(shapes[0].at("fit_without_left_out").at("mean_mm"), shapes[0].at("fit").at("mean_mm"));
  EXPECT_FALSE(shapes[1].contains("left_out"));
  for (const auto& shape : shapes) EXPECT_LT(shape.at("representation").at("mean_mm"), 1.0);

  const Table scores = read_csv(at("projected/scores.csv")), own = read_csv(at("model/scores.csv"));
  EXPECT_EQ(scores.header, own.header);
  EXPECT_NEAR(parse_number(scores.rows[0][1]), parse_number(own.rows[1][1]), 0.3) << "registered anew";
  const TriangleSoup landmarks = read_mesh(at("projected/corresponding/unseen.ply")).soup;
  EXPECT_EQ(landmarks.triangles, read_mesh(at("model/mean.ply")).soup.triangles);
  EXPECT_THAT(bytes_of(at("projected/residual/unseen.ply")), HasSubstr("property float distance_mm"));
  EXPECT_EQ(read_mesh(at("projected/residual/unseen.ply")).soup.points,
            read_mesh(at("unseen.ply")).soup.points);

  // The results of a projection can be measured and reconstructed.
  EXPECT_EQ(run("reconstruct " + at("model") + " " + at("projected/scores.csv") + " -o " + at("back")).code,
            0);
}

TEST_F(UseModel, ProjectNamesWhatItCannotUse) {
  TriangleSoup open = read_mesh(at("unseen.ply")).soup;
  open.triangles.pop_back();
  write_ply(at("open.ply"), open);
  const Outcome refused =
      run("project " + at("model") + " " + at("open.ply") + " " + at("unseen.ply") + " -o " + at("mixed"));
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.output, HasSubstr("open.ply"));
  EXPECT_TRUE(fs::exists(at("mixed/fit/unseen.ply"))) << "one bad surface does not cost the others";
  const Outcome nobody =
      run("project " + at("model") + " " + at("unseen.ply") + " -o " + at("none") + " --leave-out nobody");
  EXPECT_EQ(nobody.code, 1);
  EXPECT_THAT(nobody.output, HasSubstr("nobody"));
  EXPECT_FALSE(fs::exists(at("none")));
  const Outcome two = run("project --leave-out synth001,synth003 --json " + at("model") + " " +
                          at("unseen.ply") + " -o " + at("without_two"));
  EXPECT_EQ(two.code, 0) << two.output;
  EXPECT_THAT(bytes_of(at("without_two/project.json")), HasSubstr("\"synth003\""));
}

TEST_F(UseModel, CompleteGivesTheWholeWithItsDeviation) {
  TriangleSoup part = read_mesh(at("unseen.ply")).soup;
  const BoundingBox box = bounding_box(part.points);
  const double limit = 0.5 * (box.low.y() + box.high.y());
  std::erase_if(part.triangles, [&](const auto& t) {
    return std::any_of(t.begin(), t.end(), [&](int v) { return part.points[v].y() > limit; });
  });
  write_ply(at("part.ply"), part, AnatomicalSpace::ras);
  const Outcome completed =
      run("complete --json " + at("model") + " " + at("part.ply") + " -o " + at("whole"));
  ASSERT_EQ(completed.code, 0) << completed.output;
  const auto summary = nlohmann::json::parse(bytes_of(at("whole/complete.json")));
  EXPECT_LT(summary.at("distance_mm"), 1.0);
  EXPECT_LT(summary.at("standard_deviation_seen_mm"), summary.at("standard_deviation_unseen_mm"));
  const MeshFile whole = read_mesh(at("whole/completed.ply"));
  EXPECT_EQ(whole.space, AnatomicalSpace::ras);
  EXPECT_EQ(whole.soup.triangles, read_mesh(at("model/mean.ply")).soup.triangles);
  EXPECT_THAT(bytes_of(at("whole/completed.ply")), HasSubstr("property float standard_deviation_mm"));
  // The posterior is a model like any other.
  EXPECT_EQ(run("sample -n 2 " + at("whole/posterior.h5") + " -o " + at("drawn")).code, 0);

  std::ofstream(at("empty.ply")) << "";
  const Outcome refused = run("complete " + at("model") + " " + at("empty.ply") + " -o " + at("none"));
  EXPECT_EQ(refused.code, 1);
  EXPECT_THAT(refused.output, HasSubstr("empty.ply"));
  EXPECT_EQ(run("complete --noise 0 " + at("model") + " " + at("part.ply") + " -o x").code, 2);
}

TEST_F(UseModel, MetresAreRefusedUnlessTheUnitIsGiven) {
  const auto in_metres = [&](const std::string& from, const std::string& to) {
    TriangleSoup soup = read_mesh(at(from)).soup;
    for (Vec3& p : soup.points) p /= 1000;
    write_ply(at(to), soup);
    return at(to);
  };
  std::ofstream(at("width.json")) << R"({"points": {"a": 0, "b": 9}, "distances": {"ab": ["a", "b"]}})";
  const std::string surface = in_metres("synth/shapes/synth002.ply", "metres.ply");
  const std::string mean = in_metres("model/mean.ply", "mean_metres.ply");
  for (const std::string& command :
       {"project " + at("model") + " " + surface + " -o " + at("of_metres"),
        "complete " + at("model") + " " + surface + " -o " + at("of_metres"),
        "measure " + at("model") + " " + at("width.json") + " " + mean + " -o " + at("of_metres.csv")}) {
    const Outcome refused = run(command);
    EXPECT_EQ(refused.code, 1) << command << refused.output;
    EXPECT_THAT(refused.output, HasSubstr("probably in m, give this unit (--units m)"));
    const Outcome taken = run(command + " --units m");
    EXPECT_EQ(taken.code, 0) << taken.output;
    EXPECT_THAT(taken.output, Not(HasSubstr("--units")));
  }
  const BoundingBox whole = bounding_box(read_mesh(at("of_metres/completed.ply")).soup.points);
  EXPECT_NEAR(whole.diagonal(), bounding_box(read_mesh(surface).soup.points).diagonal(), 0.005);
  const Outcome insisted = run("measure --units mm " + at("model") + " " + at("width.json") + " " + mean +
                               " -o " + at("of_metres.csv"));
  EXPECT_EQ(insisted.code, 0) << insisted.output;
  EXPECT_THAT(insisted.output, HasSubstr("warning: 1 of 1 shapes is not the size of a vertebra"));
}

// How often a text has these words.
int count_of(const std::string& words, const std::string& text) {
  int count = 0;
  for (std::size_t at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
  return count;
}

TEST_F(UseModel, ALabelMapIsToBeExtracted) {
  std::ofstream(at("spine.nii.gz")) << "voxels";
  std::ofstream(at("none.json")) << R"({"points": {"a": 0}})";
  const std::string map = at("spine.nii.gz");
  for (const std::string& command :
       {"project " + at("model") + " " + map + " -o " + at("of_map"),
        "complete " + at("model") + " " + map + " -o " + at("of_map"),
        "measure " + at("model") + " " + at("none.json") + " " + map + " -o " + at("of_map.csv")}) {
    const Outcome refused = run(command);
    EXPECT_EQ(refused.code, 1) << command << refused.output;
    EXPECT_THAT(refused.output, HasSubstr("(run `foramen extract` first)"));
    EXPECT_EQ(count_of("spine.nii.gz", refused.output), 1) << refused.output;
  }
}

TEST_F(UseModel, ProjectEndsWithWhatFailedAndSaysEachStageOnce) {
  std::ofstream(at("bad.ply")) << "";
  const Outcome none = run("project " + at("model") + " " + at("bad.ply") + " -o " + at("ended"));
  EXPECT_EQ(none.code, 1);
  EXPECT_THAT(none.output, HasSubstr("foramen: the surface was not projected\n"));
  ASSERT_EQ(
      run("build --method icp --landmarks 300 --samples 2 --quiet " + at("synth/shapes") + " -o " + at("icp"))
          .code,
      0);
  const Outcome some = run("project " + at("icp") + " " + at("bad.ply") + " " +
                           at("synth/shapes/synth002.ply") + " -o " + at("ended"));
  EXPECT_EQ(some.code, 1);
  EXPECT_THAT(some.output, HasSubstr("foramen: 1 of 2 surfaces was not projected\n"));
  for (const char* stage : {"model\n", "shortest loops\n", "project\n"})
    EXPECT_EQ(count_of(stage, some.output), 1) << some.output;
  EXPECT_EQ(some.output.find('%'), std::string::npos);
  const Outcome file =
      run("project " + at("model/model.h5") + " " + at("synth/shapes/synth002.ply") + " -o " + at("ended"));
  EXPECT_EQ(file.code, 1);
  EXPECT_THAT(file.output, HasSubstr("which only the folder of a build holds"));
}

TEST_F(UseModel, MeasureWritesARowAShape) {
  std::ofstream(at("measures.json")) << R"({"points": {"a": 0, "b": 9, "c": [0, 0, 0]},
    "distances": {"ab": ["a", "b"]}, "regions": {"all": {"centre": "c", "radius_mm": 500}}})";
  const std::string measure = "measure " + at("model") + " " + at("measures.json");
  ASSERT_EQ(run(measure + " -o " + at("own.csv")).code, 0);
  const Table own = read_csv(at("own.csv"));
  ASSERT_EQ(own.rows.size(), 4u);
  EXPECT_EQ(own.header[own.column("ab_mm")], "ab_mm");
  const TriangleSoup second = read_mesh(at("model/corresponding/synth002.ply")).soup;
  EXPECT_EQ(own.rows[1][0], "synth002");
  EXPECT_NEAR(parse_number(own.rows[1][own.column("ab_mm")]), (second.points[0] - second.points[9]).norm(),
              1e-9);
  EXPECT_NEAR(parse_number(own.rows[1][own.column("all_mm2")]), total_area(build_mesh(second)), 1e-6);
  EXPECT_NEAR(parse_number(own.rows[1][own.column("b_y_mm")]), second.points[9].y(), 1e-9);

  EXPECT_EQ(run(measure + " " + at("model/mean.ply") + " -o " + at("mean.csv")).code, 0);
  const Outcome other = run(measure + " " + at("unseen.ply") + " -o " + at("other.csv"));
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.output, HasSubstr("unseen.ply"));
  EXPECT_FALSE(fs::exists(at("other.csv")));
  for (const char* definitions : {"{\"points\": ", "\x1f\x8b"}) {
    std::ofstream(at("measures.json")) << definitions;
    const Outcome broken = run(measure + " -o " + at("own.csv"));
    EXPECT_EQ(broken.code, 1);
    EXPECT_THAT(broken.output, HasSubstr("measures.json: is no JSON from byte "));
    EXPECT_EQ(broken.output.find("exception"), std::string::npos);
  }
  EXPECT_THAT(run("measure " + at("model") + " " + at("model") + " -o " + at("own.csv")).output,
              HasSubstr("is a folder"));
  std::ofstream(at("measures.json")) << R"({"distances": {"ab": ["a", "b"]}})";
  EXPECT_THAT(run(measure + " -o " + at("own.csv")).output, HasSubstr("measures.json"));
}

}  // namespace
}  // namespace foramen
