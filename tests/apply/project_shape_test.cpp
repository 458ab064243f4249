#include "foramen/apply/project_shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

AlignedModel small_model(ScaleMode scale) {
  AlignedCohort cohort = align_cohort(testing::torus_cohort(), scale);
  return {std::move(cohort.alignment), std::move(cohort.model)};
}

class ProjectShape : public ::testing::TestWithParam<ScaleMode> {};

TEST_P(ProjectShape, OfATrainingShapeIsThatShapeInAnyPose) {
  const AlignedModel model = small_model(GetParam());
  Rng rng(3);
  const std::vector<Vec3> shape = testing::torus_cohort().corresponding[2];
  const Eigen::VectorXd own = model.model.scores(flattened(model.alignment.aligned[2]), model.model.modes())
                                  .cwiseQuotient(model.model.variance().cwiseSqrt());
  for (int k = 0; k < 3; ++k) {
    const RigidTransform pose = testing::random_pose(rng);
    std::vector<Vec3> moved;
    for (const Vec3& p : shape) moved.push_back(pose * p);
    const ProjectedShape projected = project_shape(moved, model, GetParam());
    EXPECT_LT((projected.scores - own).norm(), 1e-6);
    EXPECT_LT(projected.landmark_rms, 1e-8);
    for (std::size_t i = 0; i < moved.size(); ++i) EXPECT_LT((projected.fit[i] - moved[i]).norm(), 1e-6);
  }
}

TEST_P(ProjectShape, WithoutAShapeTheModelIsThatOfTheOthers) {
  const AlignedModel model = small_model(GetParam());
  const testing::TorusCohortOptions options;
  CorrespondingCohort others = testing::torus_cohort(options);
  const std::vector<std::string> names = others.names;
  others.corresponding.erase(others.corresponding.begin() + 1);
  others.inputs.erase(others.inputs.begin() + 1);
  others.names.erase(others.names.begin() + 1);
  others.subjects.erase(others.subjects.begin() + 1);
  const AlignedCohort anew = align_cohort(others, GetParam());
  const std::vector<std::string> left_out{names[1]};
  const AlignedModel without = model_without(model, names, left_out, GetParam());
  ASSERT_EQ(without.model.modes(), model.model.modes() - 1);
  // The removed sizes are relative to the mean size of all shapes, so variances differ by the square of the
  // ratio of mean sizes.
  const double ratio = without.model.variance()[0] / anew.model.variance()[0];
  EXPECT_NEAR(ratio, 1, GetParam() == ScaleMode::keep ? 1e-6 : 0.1);
  EXPECT_TRUE(without.model.variance().isApprox(ratio * anew.model.variance(), 1e-6));
}

TEST(ProjectShape, RefusesNamesAndShapesThatDoNotFit) {
  const AlignedModel model = small_model(ScaleMode::keep);
  const std::vector<std::string> names = testing::torus_cohort().names;
  const std::vector<std::string> unknown{"nobody"};
  try {
    model_without(model, names, unknown, ScaleMode::keep);
    FAIL();
  } catch (const InvalidInput& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("nobody"));
    EXPECT_THAT(e.what(), ::testing::HasSubstr(names[4]));
  }
  const std::vector<std::string> all_but_one(names.begin(), names.end() - 1);
  EXPECT_THROW(model_without(model, names, all_but_one, ScaleMode::keep), InvalidInput);
  EXPECT_THROW(project_shape(std::vector<Vec3>(3, Vec3::Zero()), model, ScaleMode::keep), InvalidInput);
}

INSTANTIATE_TEST_SUITE_P(Scale, ProjectShape, ::testing::Values(ScaleMode::keep, ScaleMode::remove));

}  // namespace
}  // namespace foramen
