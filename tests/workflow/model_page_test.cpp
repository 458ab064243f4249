#include "pages/model_page.hpp"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "pages/report_data.hpp"
#include "report/encoded_array.hpp"
#include "report/interactive_page.hpp"
#include "support/temporary_folder.hpp"
#include "support/torus_family.hpp"
#include "workflow/run_build.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

// A model of four shapes, one of five inputs left out, and its baseline.
class ModelPageOf : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    const fs::path shapes = folder_->file("shapes");
    fs::create_directories(shapes);
    for (const Shape& shape : testing::family()) write_ply(shapes / (shape.name + ".ply"), shape.mesh.soup());
    std::ofstream(shapes / "broken.ply") << "no mesh";
    build(shapes, model(), 300, LandmarkWeights::equal);
    build(shapes, baseline(), 200, LandmarkWeights::area);
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path model() { return folder_->file("model"); }
  static fs::path baseline() { return folder_->file("closest"); }

 private:
  static void build(const fs::path& shapes, const fs::path& output, int landmarks, LandmarkWeights weights) {
    BuildRequest request;
    request.inputs = {shapes};
    request.output = output;
    request.build.correspondence.method = Method::icp;  // the cheaper one
    request.build.landmarks.count = landmarks;
    request.build.model.weights = weights;
    request.evaluation = {.draws = 5, .samples = 500, .specificity_samples = 100};
    request.subject_pattern = "s.";
    request.canonical_command = "foramen build <shapes>";
    run_build(request, RunContext(2));
  }
  static inline testing::TemporaryFolder* folder_ = nullptr;
};

std::string encoded_floats(const Eigen::VectorXd& values) {
  const std::vector<float> floats(values.begin(), values.end());
  return encoded(std::span<const float>(floats), {floats.size()}).base64;
}

TEST_F(ModelPageOf, ThePlainPageSaysThatItIsAndWhy) {
  const ModelPage page = model_page(model(), {.kind = PageKind::plain});
  EXPECT_EQ(page.kind, PageKind::plain);
  EXPECT_THAT(page.html, HasSubstr("This is the plain page"));
  EXPECT_THAT(page.html, HasSubstr("learnt from 4 vertebrae of 4 subjects"));
  EXPECT_THAT(page.html, HasSubstr("broken"));
  EXPECT_THAT(page.html, Not(HasSubstr("<script")));
  EXPECT_THAT(page.remark, HasSubstr("plain page"));
}

TEST_F(ModelPageOf, ABuildWritesTheBestPageItCan) {
  const ModelPage page = model_page(model());
  EXPECT_EQ(page.kind, has_viewer() ? PageKind::interactive : PageKind::plain);
  EXPECT_EQ(testing::bytes_of(model() / "report.html"), page.html);
  EXPECT_EQ(testing::bytes_of(baseline() / "report.html"), model_page(baseline()).html)
      << "with landmark weights";
  if (has_viewer()) return;
  EXPECT_THROW(model_page(model(), {.kind = PageKind::interactive}), InvalidInput);
}

TEST_F(ModelPageOf, ABaselineBringsItsCurvesAndTheDifferences) {
  const std::string with = model_page(model(), {.kind = PageKind::plain, .baseline = baseline()}).html;
  EXPECT_THAT(with, HasSubstr("baseline: closest"));
  EXPECT_THAT(with, HasSubstr("This model minus the baseline"));
  EXPECT_THAT(model_page(model(), {.kind = PageKind::plain}).html,
              Not(HasSubstr("This model minus the baseline")));
  EXPECT_THROW(model_page(model(), {.baseline = model() / "nowhere"}), IoError);
}

TEST_F(ModelPageOf, TheDataAreTheModelAndItsShapes) {
  const ModelRecord record = read_model_record(model());
  const auto data = report_data(record, page_contents(record, std::nullopt));
  const ShapeModel& shape_model = record.loaded.model;
  EXPECT_EQ(data.at("format"), "foramen-report");
  EXPECT_EQ(data.at("model").at("mean").at("base64"), encoded_floats(shape_model.mean()));
  Eigen::VectorXd modes(shape_model.basis().size());
  for (int m = 0; m < shape_model.modes(); ++m)
    modes.segment(m * shape_model.mean().size(), shape_model.mean().size()) =
        shape_model.basis().col(m) * std::sqrt(shape_model.variance()[m]);
  EXPECT_EQ(data.at("model").at("modes").at("base64"), encoded_floats(modes));
  ASSERT_EQ(data.at("shapes").size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& shape = data.at("shapes").at(i);
    EXPECT_EQ(shape.at("name"), "s" + std::to_string(i));
    EXPECT_EQ(shape.at("subject"), "s" + std::to_string(i));
    ASSERT_EQ(shape.at("scores").size(), shape_model.modes());
    for (int m = 0; m < shape_model.modes(); ++m)
      EXPECT_NEAR(shape.at("scores").at(m).get<double>(),
                  record.loaded.scores(m, static_cast<Eigen::Index>(i)), 1e-6);
  }
  EXPECT_EQ(data.at("left_out").at("rows").at(0).at(0), "broken");
  EXPECT_EQ(data.at("charts").at(0).at("series").size(), 1u);
  EXPECT_EQ(data.at("loops").size(), 2u);
}

TEST_F(ModelPageOf, TheLargestErrorOfAShapeIsCloseToItsHausdorffDistance) {
  const ModelRecord record = read_model_record(model());
  for (std::size_t i = 0; i < record.error_maps.size(); ++i) {
    const auto& errors = record.error_maps[i].landmark_mm;
    const double largest = *std::max_element(errors.begin(), errors.end());
    const double hausdorff = record.evaluation.representation.shapes[i].distance.hausdorff;
    EXPECT_GT(largest, 0.8 * hausdorff);
    EXPECT_LT(largest, 1.25 * hausdorff);
  }
}

TEST_F(ModelPageOf, FilesOfTwoModelsAreRefused) {
  const testing::TemporaryFolder mixed;
  fs::copy(model(), mixed.path(), fs::copy_options::recursive);
  fs::copy_file(baseline() / "atlas.h5", mixed.file("atlas.h5"), fs::copy_options::overwrite_existing);
  EXPECT_THROW(model_page(mixed.path()), IoError);
  fs::copy_file(model() / "atlas.h5", mixed.file("atlas.h5"), fs::copy_options::overwrite_existing);
  EXPECT_NO_THROW(model_page(mixed.path()));
  RunRecord run = read_run(model());
  run.shapes.erase(run.shapes.begin());
  std::ofstream(mixed.file("run.json")) << run_json(run);
  EXPECT_THROW(model_page(mixed.path()), IoError);
  fs::remove(mixed.file("run.json"));
  EXPECT_THROW(model_page(mixed.path()), IoError);
}

}  // namespace
}  // namespace foramen
