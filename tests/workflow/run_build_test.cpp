#include "workflow/run_build.hpp"

#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "foramen/core/geometry.hpp"
#include "foramen/io/mesh_file.hpp"
#include "support/temporary_folder.hpp"
#include "support/torus_family.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;

// Builds of a small family of shapes in a folder. All builds use the same store.
class RunBuildWithStore : public ::testing::Test {
 protected:
  RunBuildWithStore() {
    fs::create_directories(shapes());
    for (const Shape& shape : testing::family()) add(shape);
  }
  void add(const Shape& shape) const { write_ply(shapes() / (shape.name + ".ply"), shape.mesh.soup()); }
  fs::path shapes() const { return folder_.file("shapes"); }
  fs::path model(const std::string& name) const { return folder_.file(name); }

  /// Runs the build and returns the number of stages that were taken from the store.
  int build(const std::string& name) const {
    BuildRequest request;
    request.inputs = {shapes()};
    request.output = model(name);
    request.store = folder_.file("store");
    request.build.correspondence.method = Method::icp;  // the cheapest
    request.build.correspondence.reference = "s1";
    request.build.landmarks.count = 200;
    request.evaluation = {.draws = 5, .samples = 300, .specificity_samples = 100};
    request.canonical_command = "foramen build <shapes>";
    const BuildSummary summary = run_build(request, RunContext(2));
    return nlohmann::json::parse(summary.json).at("stages_taken_up");
  }
  std::string bytes(const std::string& name, const std::string& file) const {
    return testing::bytes_of(model(name) / file);
  }

 private:
  testing::TemporaryFolder folder_;
};

TEST_F(RunBuildWithStore, ASecondBuildTakesUpAllOfTheFirst) {
  EXPECT_EQ(build("first"), 0);
  EXPECT_FALSE(fs::exists(model("first") / ".resume"));
  EXPECT_EQ(build("second"), 1 + 3 + 4 + 1) << "reference, alignments, generalization, draws";
  for (const std::string file : {"model.h5", "mean.ply", "scores.csv", "metrics.json", "metrics.csv"})
    EXPECT_EQ(bytes("first", file), bytes("second", file)) << file;
}

TEST_F(RunBuildWithStore, AFurtherShapeRenamesNothingThatDoesNotDependOnIt) {
  build("four");
  const Mesh another = build_mesh(testing::lopsided_torus_soup(50, 26, 1.5));
  add({"another", another});
  EXPECT_EQ(build("five"), 1 + 3) << "the reference and the alignments of the other shapes";
}

}  // namespace
}  // namespace foramen
