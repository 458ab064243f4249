#include "pages/render_model.hpp"

#include <algorithm>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/io/mesh_file.hpp"
#include "modelfiles/metrics_file.hpp"
#include "render/render_scene.hpp"
#include "support/messages.hpp"
#include "support/temporary_folder.hpp"
#include "support/torus_family.hpp"
#include "workflow/run_build.hpp"
#include "workflow/write_comparison.hpp"
#include "workflow/write_pictures.hpp"

namespace foramen {
namespace {

namespace fs = std::filesystem;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

// A model of four shapes and its baseline.
class RenderModel : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    const fs::path shapes = folder_->file("shapes");
    fs::create_directories(shapes);
    for (const Shape& shape : testing::family()) write_ply(shapes / (shape.name + ".ply"), shape.mesh.soup());
    build(shapes, model(), 300);
    build(shapes, baseline(), 200);
  }
  static void TearDownTestSuite() { delete folder_; }
  static fs::path model() { return folder_->file("model"); }
  static fs::path baseline() { return folder_->file("closest"); }

 private:
  static void build(const fs::path& shapes, const fs::path& output, int landmarks) {
    BuildRequest request;
    request.inputs = {shapes};
    request.output = output;
    request.build.correspondence.method = Method::icp;  // the cheaper one
    request.build.landmarks.count = landmarks;
    request.evaluation = {.draws = 5, .samples = 500, .specificity_samples = 100};
    request.canonical_command = "foramen build <shapes>";
    run_build(request, RunContext(2));
  }
  static inline testing::TemporaryFolder* folder_ = nullptr;
};

std::vector<std::string> names_of(const std::vector<RenderedFile>& files) {
  std::vector<std::string> names;
  for (const RenderedFile& file : files) names.push_back(file.name);
  return names;
}

const RenderedFile& named(const std::vector<RenderedFile>& files, const std::string& name) {
  return *std::find_if(files.begin(), files.end(), [&](const RenderedFile& f) { return f.name == name; });
}

TEST_F(RenderModel, CurvesNeedNoDisplay) {
  const auto files = render_model(model(), {.only_curves = true});
  EXPECT_THAT(names_of(files), IsSupersetOf({"generalization.svg", "generalization.pdf", "specificity.svg",
                                             "specificity.pdf", "compactness.svg", "compactness.pdf"}));
  for (const RenderedFile& file : files) {
    EXPECT_THAT(file.name, AnyOf(HasSubstr(".svg"), HasSubstr(".pdf")));
    EXPECT_EQ(file.bytes.substr(0, 4), file.name.ends_with(".svg") ? "<svg" : "%PDF") << file.name;
    EXPECT_FALSE(file.caption.empty());
  }
}

TEST_F(RenderModel, PicturesAreWrittenUnderTheirNames) {
  const fs::path folder = model() / "pictures";
  const auto files = render_model(model(), {.only_curves = true});
  const auto written = write_pictures({model(), folder, {.only_curves = true}});
  ASSERT_EQ(written.size(), files.size());
  for (std::size_t i = 0; i < files.size(); ++i) {
    EXPECT_EQ(written[i].file, folder / files[i].name);
    EXPECT_EQ(written[i].caption, files[i].caption);
    EXPECT_TRUE(testing::bytes_of(written[i].file) == files[i].bytes) << files[i].name;
  }
}

TEST_F(RenderModel, AComparisonIsAPageARecordAndCharts) {
  const fs::path folder = model() / "comparison";
  const ComparisonSummary summary = write_comparison({.models = {model(), baseline()}, .output = folder});
  EXPECT_EQ(summary.page, folder / "compare.html");
  EXPECT_THAT(summary.text, HasSubstr("closest minus model: Specificity"));
  EXPECT_EQ(testing::bytes_of(folder / "compare.json"), summary.json + "\n");
  const std::string page = testing::bytes_of(summary.page);
  for (const std::string chart : {"generalization.svg", "specificity.svg"})
    EXPECT_THAT(testing::bytes_of(folder / chart), HasSubstr("<svg")) << chart;
  EXPECT_THAT(page, HasSubstr("closest"));
  EXPECT_THROW(write_comparison({.models = {model(), folder}, .output = model() / "none"}), IoError);
  EXPECT_FALSE(fs::exists(model() / "none"));
}

TEST_F(RenderModel, ABaselineIsASecondCurve) {
  const auto alone = render_model(model(), {.only_curves = true});
  const auto both = render_model(model(), {.baseline = baseline(), .only_curves = true});
  EXPECT_THAT(named(alone, "specificity.svg").bytes, Not(HasSubstr("series-1")));
  EXPECT_THAT(named(both, "specificity.svg").bytes, HasSubstr("series-1"));
  EXPECT_THAT(named(both, "specificity.svg").bytes, HasSubstr("baseline: closest"));
  EXPECT_THAT(named(both, "specificity.pdf").bytes, HasSubstr("(baseline: closest)"));
}

TEST_F(RenderModel, MarksHaveAPicture) {
  if (!can_render()) GTEST_SKIP() << "needs VTK and a display";
  const testing::TemporaryFolder marked;
  fs::copy(model(), marked.path(), fs::copy_options::recursive);
  Evaluation evaluation = read_metrics(model());
  const SurfacePoint place{FaceId(5), {0.5, 0.25, 0.25}}, other{FaceId(90), {0.5, 0.25, 0.25}};
  evaluation.marks.emplace().placed = {{"tip", MarkKind::point, 0, {place}},
                                       {"rim", MarkKind::open_curve, 2, {place, other}}};
  std::ofstream(marked.file("metrics.json")) << metrics_json(evaluation);
  const auto files = render_model(marked.path());
  EXPECT_EQ(named(files, "marks.png").bytes.substr(0, 4), "\x89PNG");
  EXPECT_THAT(names_of(render_model(model())), Not(Contains("marks.png")));
}

TEST_F(RenderModel, WithoutADisplayItSaysSo) {
  if (can_render()) GTEST_SKIP() << "there is a display";
  try {
    render_model(model());
    FAIL() << "pictures without a display";
  } catch (const Error& e) {
    EXPECT_THAT(e.what(), HasSubstr("xvfb-run"));
    EXPECT_THAT(message_of(e), testing::offers({{RemedyKind::only_curves}}));
  }
}

TEST_F(RenderModel, EveryPictureIsMade) {
  if (!can_render()) GTEST_SKIP() << "needs VTK and a display";
  const auto files = render_model(model(), {.baseline = baseline()});
  EXPECT_THAT(names_of(files), IsSupersetOf({"loops.png", "torus_map.png", "overview.png", "modes.png",
                                             "mode1.png", "distances_mean.png", "distances_worst.png",
                                             "first_mode_beside.png", "flips.png", "specificity.svg"}));
  for (const RenderedFile& file : files) {
    if (file.name.ends_with(".png")) {
      EXPECT_EQ(file.bytes.substr(0, 4), "\x89PNG") << file.name;
    }
  }
  EXPECT_THAT(named(files, "distances_worst.png").caption, HasSubstr(" mm"));
  EXPECT_THAT(names_of(render_model(model())), Not(Contains("flips.png")));
}

}  // namespace
}  // namespace foramen
