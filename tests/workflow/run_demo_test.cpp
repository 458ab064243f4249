#include "workflow/run_demo.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "foramen/io/mesh_file.hpp"
#include "support/temporary_folder.hpp"
#include "workflow/write_synth_cohort.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

TEST(WriteSynthCohort, WritesEachShapeWithItsTruth) {
  const testing::TemporaryFolder folder;
  const SynthOptions options{.shapes = 2, .seed = 5, .vertices = 1500};
  const SynthSummary written = write_synth_cohort({folder.file("cohort"), options}, RunContext(2));
  EXPECT_EQ(written.shapes, 2);
  const auto shapes = synth_cohort(options, RunContext(2));
  EXPECT_EQ(read_mesh(written.surfaces / "synth002.ply").soup.triangles, shapes[1].surface.triangles);
  EXPECT_EQ(read_mesh(written.truth / "synth002.ply").soup.triangles, shapes[1].truth.triangles);
  EXPECT_NE(shapes[1].surface.triangles, shapes[1].truth.triangles);
}

TEST(RunDemo, BuildsItsCohortAndMeasuresTheModelByTheTruth) {
  const testing::TemporaryFolder folder;
  DemoRequest request{.output = folder.file("demo"),
                      .synth = {.shapes = 3, .seed = 5, .vertices = 1500},
                      .evaluation = {.draws = 2, .samples = 100, .specificity_samples = 10},
                      .canonical_command = "demo"};
  request.build.correspondence.method = Method::icp;  // the cheapest
  request.build.landmarks.count = 200;
  const DemoSummary summary = run_demo(request, RunContext(2));
  EXPECT_TRUE(summary.build.left_out.empty());
  EXPECT_EQ(summary.report, folder.file("demo/model/report.html"));
  EXPECT_TRUE(fs::exists(summary.report));
  const auto metrics = nlohmann::json::parse(testing::bytes_of(folder.file("demo/model/metrics.json")));
  EXPECT_EQ(metrics.at("names").size(), 3u);
  EXPECT_TRUE(metrics.contains("truth"));
}

}  // namespace
}  // namespace foramen
