// A cohort whose files have the same names in several folders, from the files to the model's folder.
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/io/mesh_file.hpp"
#include "modelfiles/metrics_file.hpp"
#include "support/temporary_folder.hpp"
#include "support/torus_family.hpp"
#include "workflow/evaluate_folder.hpp"
#include "workflow/run_build.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

TEST(NamesByFolder, NameTheShapesTheirFilesTheirSubjectsAndTheirOriginals) {
  const testing::TemporaryFolder folder;
  const auto family = testing::family();
  ASSERT_EQ(family.size(), 4);
  for (std::size_t i = 0; i < family.size(); ++i) {
    const fs::path patient = folder.file("shapes") / (i < 2 ? "p1" : "p2") / "segmentations";
    fs::create_directories(patient);
    write_ply(patient / (i % 2 == 0 ? "L1.ply" : "L2.ply"), family[i].mesh.soup());
  }
  BuildRequest request;
  request.inputs = {folder.file("shapes")};
  request.output = folder.file("model");
  request.build.correspondence.method = Method::icp;  // the cheapest
  request.build.correspondence.reference = "p1_L1";
  request.build.landmarks.count = 200;
  request.evaluation = {.draws = 5, .samples = 300, .specificity_samples = 100};
  run_build(request, RunContext(2));

  const auto names = ElementsAre("p1_L1", "p1_L2", "p2_L1", "p2_L2");
  const Evaluation metrics = read_metrics(request.output);
  EXPECT_THAT(metrics.names, names);
  EXPECT_THAT(metrics.subjects, ElementsAre("p1", "p1", "p2", "p2"));
  EXPECT_TRUE(fs::exists(request.output / "corresponding" / "p2_L1.ply"));

  EvaluateFolderRequest again;
  again.corresponding = request.output;
  again.shapes = folder.file("shapes");
  again.options = request.evaluation;
  const Evaluation evaluated = evaluate_folder(again, RunContext(2)).evaluation;
  EXPECT_THAT(evaluated.names, names);
  EXPECT_EQ(evaluated.subjects, metrics.subjects);
  EXPECT_NEAR(evaluated.representation.mean_surface.mean, metrics.representation.mean_surface.mean, 1e-3)
      << "the distances are to each shape's own surface; files are of single precision";
}

}  // namespace
}  // namespace foramen
