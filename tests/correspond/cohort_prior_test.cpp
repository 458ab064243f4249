#include "correspond/cohort_prior.hpp"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "match/smooth_displacements.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen {
namespace {

class CohortPrior : public ::testing::Test {
 protected:
  const Mesh surface = build_mesh(testing::knobbly_torus_soup(30, 18));
  const Eigen::MatrixXd functions = smooth_displacements(surface.positions());
  const Eigen::Index coefficients = 3 * functions.cols();

  std::vector<Vec3> displaced(const Eigen::VectorXd& a) const {
    std::vector<Vec3> points;
    for (VertexId v : surface.vertices()) {
      Vec3 p = surface.position(v);
      for (Eigen::Index c = 0; c < 3; ++c)
        p[c] += functions.row(v.index).dot(a.segment(c * functions.cols(), functions.cols()));
      points.push_back(p);
    }
    return points;
  }
  Eigen::VectorXd drawn(Rng rng) const {
    Eigen::VectorXd a(coefficients);
    for (double& x : a) x = rng.normal();
    return a;
  }
  // Shapes with independent random coefficients.
  std::vector<std::vector<Vec3>> independent(int count) const {
    std::vector<std::vector<Vec3>> shapes;
    for (int i = 0; i < count; ++i)
      shapes.push_back(displaced(drawn(Rng(3).fork(static_cast<std::uint64_t>(i)))));
    return shapes;
  }
};

TEST_F(CohortPrior, ShapesThatVaryInTwoWaysExplainEachOther) {
  const Eigen::VectorXd first = drawn(Rng(1)), second = drawn(Rng(2));
  std::vector<std::vector<Vec3>> shapes;
  Rng rng(4);
  for (int i = 0; i < 6; ++i) shapes.push_back(displaced(rng.normal() * first + rng.normal() * second));
  const CohortPriors priors = cohort_priors(surface, functions, shapes);
  EXPECT_EQ(priors.unexplained_share, CohortPriorOptions().least_share);
  for (int i = 0; i < 6; ++i) {
    const DisplacementPrior prior = priors.of_member(i);
    EXPECT_EQ(prior.variance, priors.unexplained_share);
    const Eigen::VectorXd variances = (prior.directions.transpose() * prior.directions).eigenvalues().real();
    EXPECT_EQ((variances.array() > 1e-6 * variances.maxCoeff()).count(), 2);
  }
}

TEST_F(CohortPrior, ShapesThatHaveNothingInCommonLeaveTheSmoothProcess) {
  constexpr int count = 6;
  const CohortPriors priors = cohort_priors(surface, functions, independent(count));
  // Independent shapes explain only the part of a shape that happens to lie in their span.
  EXPECT_NEAR(priors.unexplained_share, 1 - (count - 2) / static_cast<double>(coefficients), 0.05);
}

TEST_F(CohortPrior, IsWhatTheOthersHave) {
  std::vector<std::vector<Vec3>> shapes = independent(5);
  const CohortPriors before = cohort_priors(surface, functions, shapes);
  shapes[2] = displaced(Eigen::VectorXd::Constant(coefficients, 0.3));
  const CohortPriors after = cohort_priors(surface, functions, shapes);
  EXPECT_EQ(before.of_member(2).mean, after.of_member(2).mean);
  EXPECT_EQ(before.of_member(2).directions, after.of_member(2).directions);
  EXPECT_NE(before.of_member(1).mean, after.of_member(1).mean);
  EXPECT_NE(before.of_newcomer().mean, after.of_newcomer().mean);
  shapes.erase(shapes.begin() + 2);
  EXPECT_EQ(cohort_priors(surface, functions, shapes).of_newcomer().mean, after.of_member(2).mean);
}

TEST_F(CohortPrior, TwoShapesTeachNothing) {
  const CohortPriors priors = cohort_priors(surface, functions, independent(2));
  EXPECT_EQ(priors.unexplained_share, 1);
  for (int i = 0; i < 2; ++i) {
    const DisplacementPrior prior = priors.of_member(i);
    EXPECT_EQ(prior.variance, 1);
    EXPECT_EQ(prior.mean.size(), 0);
    EXPECT_EQ(prior.directions.size(), 0);
  }
}

TEST_F(CohortPrior, RefusesWhatDoesNotFit) {
  std::vector<std::vector<Vec3>> shapes = independent(3);
  EXPECT_THROW(cohort_priors(surface, functions.topRows(5), shapes), InvalidInput);
  EXPECT_THROW(cohort_priors(surface, functions, shapes, {.noise_mm = 0}), InvalidInput);
  EXPECT_THROW(cohort_priors(surface, functions, shapes, {.least_share = 0}), InvalidInput);
  shapes[1].pop_back();
  EXPECT_THROW(cohort_priors(surface, functions, shapes), InvalidInput);
}

}  // namespace
}  // namespace foramen
