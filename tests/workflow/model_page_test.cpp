#include "pages/model_page.hpp"

#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "modelfiles/metrics_file.hpp"
#include "pages/page_marks.hpp"
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

// A copy of the model's folder with a point and a curve of two shapes, at the middle of triangles.
void write_marked(const fs::path& model, const fs::path& folder, int last_triangle) {
  fs::copy(model, folder, fs::copy_options::recursive);
  Evaluation evaluation = read_metrics(model);
  MarkTransfer& marks = evaluation.marks.emplace();
  const auto middle = [](int triangle) { return SurfacePoint{FaceId(triangle), {0.25, 0.25, 0.5}}; };
  for (const int shape : {1, 3}) marks.placed.push_back({"tip", MarkKind::point, shape, {middle(40)}});
  marks.placed.push_back({"rim", MarkKind::closed_curve, 2, {middle(5), middle(6), middle(last_triangle)}});
  std::ofstream(folder / "metrics.json") << metrics_json(evaluation);
}

TEST_F(ModelPageOf, MarksAreOnThePageWithTheirScatter) {
  EXPECT_THAT(model_page(model(), {.kind = PageKind::plain}).html, Not(HasSubstr("Scatter of the marks")));
  const testing::TemporaryFolder marked;
  write_marked(model(), marked.path(), 7);
  const ModelRecord record = read_model_record(marked.path());
  const auto data = report_data(record, page_contents(record, std::nullopt));
  ASSERT_EQ(data.at("marks").size(), 2u);
  const auto &tip = data.at("marks").at(0), &rim = data.at("marks").at(1);
  EXPECT_EQ(tip.at("name"), "tip");
  EXPECT_EQ(tip.at("kind"), "point");
  EXPECT_NEAR(tip.at("scatter_mm").get<double>(), 0, 1e-12) << "both shapes have it at the same place";
  EXPECT_EQ(rim.at("kind"), "closed");
  EXPECT_NE(tip.at("colour"), rim.at("colour"));
  const std::vector<std::uint32_t> shapes{1, 3}, triangles{5, 6, 7};
  EXPECT_EQ(tip.at("shapes").at("base64"), encoded(std::span<const std::uint32_t>(shapes), {2}).base64);
  EXPECT_EQ(rim.at("places").at("triangles").at("base64"),
            encoded(std::span<const std::uint32_t>(triangles), {3}).base64);
  EXPECT_THAT(model_page(marked.path(), {.kind = PageKind::plain}).html, HasSubstr("Scatter of the marks"));
}

TEST_F(ModelPageOf, MarksOfOneColourAreFarFromEachOther) {
  ModelRecord record = read_model_record(model());
  const ShapeModel& shape_model = record.loaded.model;
  const Mesh mean = build_mesh({unflattened(shape_model.mean()), shape_model.triangles()});
  std::vector<Vec3> at;
  MarkTransfer& marks = record.evaluation.marks.emplace();
  for (const int triangle : {0, 100, 200, 300, 400}) {
    const SurfacePoint place{FaceId(triangle), Vec3::Constant(1.0 / 3)};
    at.push_back(position(mean, place));
    marks.placed.push_back({"mark" + std::to_string(triangle), MarkKind::point, 0, {place}});
  }
  const std::vector<PageMark> coloured = page_marks(record);
  ASSERT_EQ(coloured.size(), 5u);
  std::set<Colour> colours;
  std::size_t farthest = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    colours.insert(coloured[i].colour);
    if ((at[i] - at[4]).norm() > (at[farthest] - at[4]).norm()) farthest = i;
  }
  EXPECT_EQ(colours.size(), 4u);
  EXPECT_EQ(coloured[4].colour, coloured[farthest].colour);
}

TEST_F(ModelPageOf, MarksOffTheModelsTrianglesAreRefused) {
  const testing::TemporaryFolder marked;
  const int triangles = static_cast<int>(read_model_record(model()).loaded.model.triangles().size());
  write_marked(model(), marked.path(), triangles);
  EXPECT_THAT([&] { model_page(marked.path()); },
              ::testing::ThrowsMessage<IoError>(HasSubstr("the mark 'rim' is on triangle")));
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
