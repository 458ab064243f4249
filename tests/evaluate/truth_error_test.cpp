#include "foramen/evaluate/truth_error.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "foramen/core/error.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

/// A cohort whose landmarks are the vertices of the truth.
TrueCorrespondence truth_of(const CorrespondingCohort& cohort) {
  return {cohort.triangles, cohort.corresponding};
}

TEST(TruthError, IsZeroForTheTruth) {
  const CorrespondingCohort cohort = testing::torus_cohort({.shapes = 4});
  const TruthError e = truth_error(cohort, truth_of(cohort), RunContext(2));
  EXPECT_LT(e.error.max, 1e-10);
  EXPECT_EQ(e.mean_from_shape.size(), 4u);
}

TEST(TruthError, FloorIsTheDistanceOfTruthAndInput) {
  CorrespondingCohort cohort = testing::torus_cohort({.shapes = 3});
  const TrueCorrespondence truth = truth_of(cohort);
  const TruthError apart = truth_error(cohort, truth, RunContext(1));
  EXPECT_GT(apart.floor.mean, 1e-3);  // the floor is positive, because the inputs have other triangles
  EXPECT_LT(apart.floor.max, 3);
  for (std::size_t s = 0; s < 3; ++s)
    cohort.inputs[s] = build_mesh({cohort.corresponding[s], cohort.triangles});
  EXPECT_LT(truth_error(cohort, truth, RunContext(1)).floor.max, 1e-10);
}

TEST(TrueLandmarks, AreFoundAgainFromThoseOfTheFirstShapeAlone) {
  CorrespondingCohort cohort = testing::torus_cohort({.shapes = 3});
  const TrueCorrespondence truth = truth_of(cohort);
  for (std::size_t s = 0; s < 3; ++s)
    cohort.inputs[s] = build_mesh({cohort.corresponding[s], cohort.triangles});
  std::reverse(cohort.corresponding[2].begin(), cohort.corresponding[2].end());  // a poor correspondence
  const auto landmarks = true_landmarks(cohort, truth, RunContext(2));
  for (std::size_t s = 0; s < 3; ++s)
    for (std::size_t i = 0; i < landmarks[s].size(); ++i)
      EXPECT_LT((landmarks[s][i] - truth.shapes[s][i]).norm(), 1e-9);
}

TEST(TruthError, MeasuresPlantedErrorsExactly) {
  CorrespondingCohort cohort = testing::torus_cohort({.shapes = 3, .shapes_per_subject = 1});
  const TrueCorrespondence truth = truth_of(cohort);
  // In shape 1 two landmarks are exchanged, and in shape 2 one landmark is moved to its neighbour's place.
  std::swap(cohort.corresponding[1][10], cohort.corresponding[1][90]);
  cohort.corresponding[2][40] = truth.shapes[2][41];

  std::vector<double> expected;
  const auto source = [](std::size_t shape,
                         std::size_t i) {  // the vertex at landmark i of a shape
    if (shape == 1 && i == 10) return std::size_t{90};
    if (shape == 1 && i == 90) return std::size_t{10};
    if (shape == 2 && i == 40) return std::size_t{41};
    return i;
  };
  std::vector<double> from_shape;
  for (std::size_t a = 0; a < 3; ++a) {
    double sum = 0;
    for (std::size_t b = 0; b < 3; ++b)
      for (std::size_t i = 0; a != b && i < truth.shapes[0].size(); ++i) {
        expected.push_back((truth.shapes[b][source(a, i)] - truth.shapes[b][source(b, i)]).norm());
        sum += expected.back();
      }
    from_shape.push_back(sum / (2.0 * static_cast<double>(truth.shapes[0].size())));
  }
  const TruthError e = truth_error(cohort, truth, RunContext(2));
  EXPECT_NEAR(e.error.mean, std::accumulate(expected.begin(), expected.end(), 0.0) / double(expected.size()),
              1e-11);
  EXPECT_NEAR(e.error.max, *std::max_element(expected.begin(), expected.end()), 1e-10);
  for (std::size_t a = 0; a < 3; ++a) EXPECT_NEAR(e.mean_from_shape[a], from_shape[a], 1e-11);
}

TEST(TruthError, MeasuresSlidingAndItsPercentile) {
  // All landmarks of one of three shapes are moved by one vertex along the tube, which affects four of six
  // ordered pairs.
  CorrespondingCohort cohort =
      testing::torus_cohort({.shapes = 3, .landmark_around = 20, .landmark_tube = 8});
  const TrueCorrespondence truth = truth_of(cohort);
  const auto slid = [](std::size_t v) { return v / 8 * 8 + (v + 1) % 8; };
  for (std::size_t v = 0; v < 160; ++v) cohort.corresponding[1][v] = truth.shapes[1][slid(v)];
  std::vector<double> expected(2 * 160, 0.0);
  for (std::size_t v = 0; v < 160; ++v) {
    for (const std::size_t b : {0u, 2u})
      expected.push_back((truth.shapes[b][slid(v)] - truth.shapes[b][v]).norm());
    for (int from = 0; from < 2; ++from)
      expected.push_back((truth.shapes[1][slid(v)] - truth.shapes[1][v]).norm());
  }
  std::sort(expected.begin(), expected.end());
  const TruthError e = truth_error(cohort, truth, RunContext(1));
  EXPECT_NEAR(e.error.mean, std::accumulate(expected.begin(), expected.end(), 0.0) / 960, 1e-11);
  EXPECT_NEAR(e.error.p95, expected[911], 1e-10);  // the 912th of 960
  EXPECT_NEAR(e.error.max, expected.back(), 1e-10);
}

TEST(TruthError, RefusesTheTruthOfOtherShapes) {
  const CorrespondingCohort cohort = testing::torus_cohort({.shapes = 3});
  TrueCorrespondence fewer = truth_of(cohort), ragged = truth_of(cohort);
  fewer.shapes.pop_back();
  ragged.shapes[1].pop_back();
  EXPECT_THROW(truth_error(cohort, fewer, RunContext(1)), InvalidInput);
  EXPECT_THROW(truth_error(cohort, ragged, RunContext(1)), InvalidInput);
}

}  // namespace
}  // namespace foramen
