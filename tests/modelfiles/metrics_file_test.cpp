#include "modelfiles/metrics_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "foramen/core/error.hpp"
#include "modelfiles/marks_json.hpp"
#include "support/temporary_folder.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;

const EvaluationOptions few_draws{.draws = 6, .samples = 200, .specificity_samples = 50};

Evaluation small_evaluation() {
  CorrespondingCohort cohort = testing::torus_cohort({.shapes = 5, .amplitude_mm = 5});
  cohort.corresponding[1][30] += 1.6 * (cohort.corresponding[1][38] - cohort.corresponding[1][30]);
  return evaluate(cohort, few_draws, RunContext(2));
}

void expect_same(const Estimate& a, const Estimate& b) {
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.standard_error, b.standard_error);
}

void expect_same_items(const Generalization& a, const Generalization& b) {
  ASSERT_EQ(a.by_modes.size(), b.by_modes.size());
  for (std::size_t k = 0; k < a.by_modes.size(); ++k) {
    ASSERT_EQ(a.by_modes[k].items.size(), b.by_modes[k].items.size());
    for (std::size_t i = 0; i < a.by_modes[k].items.size(); ++i) {
      EXPECT_EQ(a.by_modes[k].items[i].hausdorff, b.by_modes[k].items[i].hausdorff);
      EXPECT_EQ(a.by_modes[k].items[i].mean_surface, b.by_modes[k].items[i].mean_surface);
      EXPECT_EQ(a.by_modes[k].items[i].landmark_rms, b.by_modes[k].items[i].landmark_rms);
    }
  }
}

TEST(MetricsFile, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  const Evaluation written = small_evaluation();
  write_metrics(folder.path(), written);
  const Evaluation read = read_metrics(folder.path());
  EXPECT_EQ(read.names, written.names);
  EXPECT_EQ(read.total_variance, written.total_variance);
  ASSERT_EQ(read.representation.shapes.size(), 5u);
  ASSERT_GT(written.representation.shapes[1].self_intersections, 0);
  for (std::size_t i = 0; i < 5; ++i) {
    const ShapeRepresentation &a = read.representation.shapes[i], &b = written.representation.shapes[i];
    EXPECT_EQ(a.distance.mean, b.distance.mean);
    EXPECT_EQ(a.opposing_mean, b.opposing_mean);
    EXPECT_EQ(a.self_intersections, b.self_intersections);
    EXPECT_EQ(a.input_self_intersections, b.input_self_intersections);
  }
  expect_same(read.representation.self_intersections, written.representation.self_intersections);
  expect_same(read.representation.input_self_intersections, written.representation.input_self_intersections);
  ASSERT_GT(written.drawn.opposing_mean.mean, 0);
  expect_same(read.drawn.self_intersecting, written.drawn.self_intersecting);
  expect_same(read.drawn.folded, written.drawn.folded);
  expect_same(read.drawn.opposing_mean, written.drawn.opposing_mean);
  EXPECT_TRUE(read.leave_one_out.by_modes[0].items.empty());
}

TEST(MetricsFile, ItemsOfShapesComeBackFromTheTable) {
  const TemporaryFolder folder;
  const Evaluation written = small_evaluation();
  write_metrics(folder.path(), written);
  const Evaluation read = read_metrics_of_shapes(folder.path());
  expect_same_items(read.leave_one_out, written.leave_one_out);
  ASSERT_TRUE(read.leave_subject_out.has_value());
  expect_same_items(*read.leave_subject_out, *written.leave_subject_out);
}

TEST(MetricsFile, ARefitComesBackWithTheShapesThatEntered) {
  const TemporaryFolder folder;
  Evaluation written = small_evaluation();
  EXPECT_THAT(metrics_json(written), ::testing::Not(HasSubstr("refit")));
  const std::vector<std::string> entered{written.names[0], written.names[3]};
  written.refit = RefitGeneralization{
      {LeaveOut::shape, 4, over_shapes({{{3, 1, 2}, {2, 0.5, 1}}, {{5, 2, 3}, {4, 1.5, 2}}}, {1, 2})},
      entered,
      {{written.names[1], written.names[1], "no loops"}}};
  write_metrics(folder.path(), written);
  const Evaluation read = read_metrics_of_shapes(folder.path());
  ASSERT_TRUE(read.refit);
  EXPECT_FALSE(read.refit_by_subject);
  EXPECT_EQ(read.refit->names, entered);
  EXPECT_EQ(read.refit->generalization.groups, 4);
  expect_same(read.refit->generalization.by_modes[1].hausdorff,
              written.refit->generalization.by_modes[1].hausdorff);
  expect_same_items(read.refit->generalization, written.refit->generalization);
  ASSERT_EQ(read.refit->failures.size(), 1u);
  EXPECT_EQ(read.refit->failures[0].reason, "no loops");
}

TEST(MetricsFile, MarksAndRegionsComeBackByTheNamesOfTheirShapes) {
  const TemporaryFolder folder;
  Evaluation written = small_evaluation();
  EXPECT_THAT(metrics_json(written), ::testing::Not(HasSubstr("\"marks\"")));
  const TransferEstimate known{0.1, 0.25, 7}, two_subjects{0.7, {}, 2};
  written.marks = MarkTransfer{
      .points = TransferSummary{known, 2.5, 9},
      .curves = {},
      .by_point = {{"rim", MarkPart::middle, two_subjects}},
      .by_curve = {{"rim", known}},
      .pairs = {{3, 1, 0.5, {}}, {1, 4, {}, 1.0 / 3}},
      .marked_shapes = 3,
      .incomplete_shapes = 1,
      .off_surface_mm = {0, 0.25, 0, 1, 2},
      .reversed = {{4, "rim"}},
      .placed = {
          {"tip", MarkKind::point, 3, {{FaceId(7), {0.25, 0.5, 0.25}}}},
          {"rim", MarkKind::closed_curve, 4, {{FaceId(0), {1, 0, 0}}, {FaceId(9), {0, 1.0 / 3, 2.0 / 3}}}}}};
  written.regions = RegionTransfer{known, {{"arch", two_subjects}}, {{0, 2, 0.875}}, 2};
  write_metrics(folder.path(), written);
  EXPECT_THAT(testing::bytes_of(folder.file("metrics.csv")),
              HasSubstr(written.names[3] + " to " + written.names[1] + ",pair,0,mark_points,0.5,mm\n"));
  const Evaluation read = read_metrics(folder.path());
  ASSERT_TRUE(read.marks && read.regions && read.marks->points);
  EXPECT_EQ(read.marks->points->p95, 2.5);
  EXPECT_EQ(read.marks->points->errors, 9);
  EXPECT_EQ(read.marks->points->error.standard_error, 0.25);
  EXPECT_FALSE(read.marks->curves);
  EXPECT_EQ(read.marks->by_point.at(0).part, MarkPart::middle);
  EXPECT_EQ(read.marks->by_point[0].error.standard_error, std::nullopt);
  EXPECT_EQ(read.marks->by_curve.at(0).error.pairs, 7);
  EXPECT_EQ(read.marks->pairs.at(0).from, 3);
  EXPECT_EQ(read.marks->pairs[0].points, 0.5);
  EXPECT_EQ(read.marks->pairs[0].curves, std::nullopt);
  EXPECT_EQ(read.marks->pairs.at(1).curves, 1.0 / 3);
  EXPECT_EQ(read.marks->reversed.at(0).shape, 4);
  ASSERT_EQ(read.marks->placed.size(), 2u);
  const PlacedMark &tip = read.marks->placed[0], &rim = read.marks->placed[1];
  EXPECT_EQ(tip.mark, "tip");
  EXPECT_EQ(tip.shape, 3);
  EXPECT_EQ(tip.places.at(0).face.index, 7);
  EXPECT_EQ(tip.places[0].barycentric, Vec3(0.25, 0.5, 0.25));
  EXPECT_EQ(rim.kind, MarkKind::closed_curve);
  EXPECT_EQ(rim.places.at(0).barycentric, Vec3(1, 0, 0));
  EXPECT_EQ(rim.places.at(1).face.index, 9);
  EXPECT_LT((rim.places[1].barycentric - Vec3(0, 1.0 / 3, 2.0 / 3)).norm(), 1e-4);
  EXPECT_EQ(read.marks->off_surface_mm, written.marks->off_surface_mm);
  EXPECT_EQ(marks_json(*read.marks, read.names), marks_json(*written.marks, written.names));
  EXPECT_EQ(regions_json(*read.regions, read.names), regions_json(*written.regions, written.names));
}

// An evaluation with two marks whose places the test may damage.
nlohmann::ordered_json marked_metrics() {
  Evaluation e = small_evaluation();
  e.marks.emplace();
  const SurfacePoint place{FaceId(3), {0.5, 0.25, 0.25}};
  for (int s = 0; s < 2; ++s)
    e.marks->placed.push_back({"rim", MarkKind::open_curve, s, {place, place, place}});
  return nlohmann::ordered_json::parse(metrics_json(e));
}

TEST(MetricsFile, MarksWithoutPlacesAreReadAsBefore) {
  nlohmann::ordered_json metrics = marked_metrics();
  metrics["marks"].erase("placed");
  EXPECT_TRUE(parse_metrics(metrics.dump(), "m").marks->placed.empty());
}

TEST(MetricsFile, DamagedPlacesAreRefused) {
  const nlohmann::ordered_json whole = marked_metrics();
  EXPECT_EQ(parse_metrics(whole.dump(), "m").marks->placed.size(), 2u);
  const std::string mark = "/marks/placed/1/";
  for (const auto& [at, value] : {std::pair<std::string, nlohmann::ordered_json>{"triangles/1", -1},
                                  {"triangles/1", 2.5},
                                  {"triangles/1", 3000000000U},
                                  {"triangles/1", 18446744073709551615U},
                                  {"triangles/1", "3"},
                                  {"triangles", {3, 3}},
                                  {"triangles", 3},
                                  {"weights", {5000, 2500}},
                                  {"weights/0", -1},
                                  {"weights/0", 10001},
                                  {"weights/1", 5001},
                                  {"kind", "closed"},
                                  {"kind", "point"},
                                  {"kind", "surface"},
                                  {"shape", "nobody"}}) {
    nlohmann::ordered_json damaged = whole;
    damaged[nlohmann::ordered_json::json_pointer(mark + at)] = value;
    EXPECT_THROW(parse_metrics(damaged.dump(), "m"), IoError) << at << " " << value;
  }
  nlohmann::ordered_json shorter = whole;  // two points of a curve that has three on the other shape
  shorter["marks"]["placed"][1]["triangles"] = {3, 3};
  shorter["marks"]["placed"][1]["weights"] = {0, 0, 0, 0};
  EXPECT_THROW(parse_metrics(shorter.dump(), "m"), IoError);
}

TEST(MetricsFile, ATableOfAnotherEvaluationIsRefused) {
  const TemporaryFolder folder;
  write_metrics(folder.path(), small_evaluation());
  std::string table = testing::bytes_of(folder.file("metrics.csv"));
  const std::size_t row = table.find("patient1_2,shape,2,generalization_mean_surface");
  ASSERT_NE(row, std::string::npos);
  table.erase(row, table.find('\n', row) + 1 - row);
  folder.file("metrics.csv", table);
  try {
    read_metrics_of_shapes(folder.path());
    FAIL() << "not refused";
  } catch (const IoError& e) {
    EXPECT_THAT(e.what(), HasSubstr("no generalization_mean_surface of patient1_2 at 2 modes"));
  }
  std::filesystem::remove(folder.file("metrics.csv"));
  EXPECT_THROW(read_metrics_of_shapes(folder.path()), IoError);
}

}  // namespace
}  // namespace foramen
