#include "foramen/evaluate/evaluate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "foramen/core/error.hpp"
#include "spatial/flips.hpp"
#include "spatial/self_intersections.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using testing::torus_cohort;

const EvaluationOptions quick{.draws = 6, .samples = 300, .specificity_samples = 100};

TEST(ModeCounts, AreAllUpToTwentyThenPowersOfTwoAndTheLast) {
  EXPECT_THAT(mode_counts(0), IsEmpty());
  EXPECT_THAT(mode_counts(3), ElementsAre(1, 2, 3));
  const auto many = mode_counts(70);
  ASSERT_EQ(many.size(), 23u);
  EXPECT_EQ(many[19], 20);
  EXPECT_THAT(std::vector<int>(many.begin() + 20, many.end()), ElementsAre(32, 64, 70));
  EXPECT_EQ(mode_counts(64).back(), 64);
  EXPECT_EQ(mode_counts(64).size(), 22u);
  EXPECT_EQ(mode_counts(21).back(), 21);
}

TEST(Estimate, HasTheStandardErrorOfTheMean) {
  const Estimate e = estimate({1, 2, 3, 6});
  EXPECT_DOUBLE_EQ(e.mean, 3);
  EXPECT_DOUBLE_EQ(e.standard_error, std::sqrt((4 + 1 + 0 + 9) / 3.0) / 2);
  EXPECT_EQ(estimate({5}).standard_error, 0);
}

TEST(Compactness, SumsVariancesPerLandmark) {
  Eigen::VectorXd variance(3);
  variance << 6, 3, 1;
  const ShapeModel model(Eigen::VectorXd::Zero(15), Eigen::MatrixXd::Identity(15, 3), variance, {});
  const auto c = compactness(model, 4);
  ASSERT_EQ(c.size(), 4u);
  EXPECT_DOUBLE_EQ(c[0].variance_per_landmark, 6.0 / 5);
  EXPECT_DOUBLE_EQ(c[1].fraction, 0.9);
  EXPECT_DOUBLE_EQ(c[3].variance_per_landmark, 2);
  EXPECT_DOUBLE_EQ(c[3].fraction, 1);
}

TEST(Compactness, OfWeightedLandmarksIsTheWeightedMeanVariance) {
  const CorrespondingCohort cohort = torus_cohort({.shapes = 4});
  const auto weights =
      landmark_weights(cohort.corresponding, cohort.triangles, ScaleMode::keep, LandmarkWeights::area);
  const auto aligned = procrustes(cohort.corresponding, ScaleMode::keep, weights);
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    for (const auto& shape : aligned.aligned)
      sum += weights[i] * (shape[i] - aligned.mean[i]).squaredNorm() / 3;
    weight += weights[i];
  }
  EvaluationOptions options = quick;
  options.weights = LandmarkWeights::area;
  const Evaluation e = evaluate(cohort, options, RunContext(2));
  EXPECT_NEAR(e.total_variance, sum / weight, 1e-12);
  EXPECT_NEAR(e.compactness.back().variance_per_landmark, sum / weight, 1e-12);
  EXPECT_NE(e.total_variance, evaluate(cohort, quick, RunContext(2)).total_variance);
}

TEST(Representation, IsSurfaceDistanceAndFlipsOfEachShape) {
  CorrespondingCohort cohort = torus_cohort({.shapes = 3});
  // One landmark of shape 1 is moved across its neighbours.
  cohort.corresponding[1][30] += 1.6 * (cohort.corresponding[1][38] - cohort.corresponding[1][30]);
  // Two vertices of the input of shape 2, on opposite sides of its tube, change places.
  std::vector<Vec3> swapped(cohort.inputs[2].positions().begin(), cohort.inputs[2].positions().end());
  std::swap(swapped[0], swapped[8]);
  cohort.inputs[2] = cohort.inputs[2].with_positions(swapped);
  const AlignedCohort aligned = align_cohort(cohort, ScaleMode::keep);
  const SurfaceDistanceOptions options{.samples = 500, .seed = 4};
  const Representation r = representation(cohort, aligned, options, RunContext(2));
  double sum = 0;
  for (int s = 0; s < 3; ++s) {
    const std::size_t i = s;
    const Mesh mesh = corresponding_mesh(cohort, s);
    const TriangleTree input(cohort.inputs[i]);
    const SurfaceDistance d = surface_distance(TriangleTree(mesh), input, options);
    EXPECT_EQ(r.shapes[i].distance.mean, d.mean);
    EXPECT_EQ(r.shapes[i].distance.p95, d.p95);
    EXPECT_EQ(r.shapes[i].distance.hausdorff, d.hausdorff);
    EXPECT_EQ(r.shapes[i].plain_flips, static_cast<int>(sampled_flips(mesh, input).plain.size()));
    EXPECT_EQ(r.shapes[i].confirmed_flips, static_cast<int>(sampled_flips(mesh, input).confirmed.size()));
    EXPECT_EQ(r.shapes[i].self_intersections,
              static_cast<int>(self_intersections(TriangleTree(mesh)).size()));
    EXPECT_EQ(r.shapes[i].input_self_intersections, static_cast<int>(self_intersections(input).size()));
    sum += r.shapes[i].distance.hausdorff / 3;
  }
  EXPECT_NEAR(r.hausdorff.mean, sum, 1e-12);
  EXPECT_EQ(r.shapes[0].confirmed_flips, 0);
  EXPECT_GT(r.shapes[1].plain_flips, r.shapes[0].plain_flips);
  EXPECT_GT(r.shapes[1].opposing_mean, 0);
  EXPECT_EQ(r.shapes[2].opposing_mean, 0);
  EXPECT_EQ(r.shapes[0].self_intersections, 0);
  EXPECT_GT(r.shapes[1].self_intersections, 0);
  EXPECT_NEAR(r.self_intersections.mean, r.shapes[1].self_intersections / 3.0, 1e-12);
  EXPECT_EQ(r.shapes[0].input_self_intersections, 0);
  EXPECT_GT(r.shapes[2].input_self_intersections, 0);
  EXPECT_NEAR(r.input_self_intersections.mean, r.shapes[2].input_self_intersections / 3.0, 1e-12);
}

TEST(EvaluateModel, RunsEveryMeasureForItsModes) {
  const CorrespondingCohort cohort = torus_cohort({.shapes = 6});
  const TrueCorrespondence truth{cohort.triangles, cohort.corresponding};
  const Evaluation e = evaluate(cohort, quick, RunContext(2), &truth);
  EXPECT_EQ(e.landmarks, 160);
  EXPECT_EQ(e.compactness.size(), 5u);
  EXPECT_NEAR(e.compactness.back().variance_per_landmark, e.total_variance, 1e-12);
  EXPECT_EQ(e.leave_one_out.by_modes.size(), 4u);
  ASSERT_TRUE(e.leave_subject_out.has_value());
  EXPECT_EQ(e.leave_subject_out->groups, 3);
  EXPECT_EQ(e.leave_subject_out->by_modes.size(), 3u);
  EXPECT_EQ(e.specificity.by_modes.size(), 5u);
  EXPECT_EQ(e.specificity.by_modes[0].items.size(), 6u);
  EXPECT_EQ(e.ensemble.size(), 5u);
  EXPECT_EQ(e.drawn.draws.size(), 6u);
  EXPECT_EQ(e.representation.shapes.size(), 6u);
  ASSERT_TRUE(e.truth.has_value());
  EXPECT_LT(e.truth->error.max, 1e-10);
}

TEST(EvaluateModel, LeavesNoSubjectOutWhereThatIsImpossible) {
  CorrespondingCohort cohort = torus_cohort({.shapes = 3});
  cohort.subjects.clear();
  EXPECT_FALSE(evaluate(cohort, quick, RunContext(1)).leave_subject_out.has_value());
  cohort.subjects = {"a", "a", "b"};
  EXPECT_FALSE(evaluate(cohort, quick, RunContext(1)).leave_subject_out.has_value());
  EXPECT_FALSE(evaluate(cohort, quick, RunContext(1)).truth.has_value());
}

TEST(CheckCohort, NamesWhatDoesNotFit) {
  const CorrespondingCohort good = torus_cohort({.shapes = 3});
  const auto message = [](const CorrespondingCohort& cohort) {
    try {
      check_cohort(cohort);
    } catch (const InvalidInput& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_EQ(message(good), "");
  EXPECT_THAT(message(torus_cohort({.shapes = 2})), HasSubstr("at least 3"));
  CorrespondingCohort bad = good;
  bad.corresponding[2].pop_back();
  EXPECT_THAT(message(bad), HasSubstr(good.names[2]));
  bad = good;
  bad.inputs.pop_back();
  EXPECT_THAT(message(bad), HasSubstr("input surfaces"));
  bad = good;
  bad.subjects.pop_back();
  EXPECT_THAT(message(bad), HasSubstr("subjects"));
  bad = good;
  bad.triangles[4][1] = 100000;
  EXPECT_NE(message(bad), "");
  bad = good;
  bad.triangles.clear();
  EXPECT_THAT(message(bad), HasSubstr("triangles"));
}

}  // namespace
}  // namespace foramen
