#include "foramen/evaluate/drawn_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "foramen/core/error.hpp"
#include "spatial/self_intersections.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

const DrawnShapesOptions few{.draws = 40, .seed = 5};

// The distribution function of the standard normal distribution.
double below(double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); }

// P(|z| > 1 given |z| < 2) for a standard normal number z.
const double beyond_one = 2 * (below(2) - below(1)) / (below(2) - below(-2));

// A square of four triangles around a centre, which one mode moves sideways. At one standard deviation the
// centre reaches the middle of a side. Beyond it, one triangle is flipped and lies on its neighbours.
ShapeModel square_with_moving_centre() {
  const std::vector<Vec3> square{Vec3(0, 0, 0), Vec3(1, -1, 0), Vec3(1, 1, 0), Vec3(-1, 1, 0),
                                 Vec3(-1, -1, 0)};
  Eigen::MatrixXd sideways = Eigen::MatrixXd::Zero(15, 1);
  sideways(0, 0) = 1;
  return ShapeModel(flattened(square), sideways, Eigen::VectorXd::Ones(1),
                    {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
}

TEST(DrawnShapes, SharesAreThoseOfTheTruncatedNormalDistribution) {
  const DrawnShapes drawn = drawn_shapes(square_with_moving_centre(), {.draws = 20000}, RunContext(2));
  const double deviation = std::sqrt(beyond_one * (1 - beyond_one) / 20000);
  // Without truncation the share would be P(|z| > 1), which is 10 standard errors larger.
  EXPECT_NEAR(drawn.folded.mean, beyond_one, 4 * deviation);
  EXPECT_NEAR(drawn.folded.standard_error, deviation, 0.02 * deviation);
  EXPECT_EQ(drawn.opposing_mean.mean, drawn.folded.mean);
  EXPECT_EQ(drawn.self_intersecting.mean, drawn.folded.mean);
  for (const DrawnShape& d : drawn.draws) {
    EXPECT_EQ(d.self_intersections > 0, d.opposing_mean > 0);
    EXPECT_EQ(d.folded, d.opposing_mean);
    EXPECT_LE(d.folded, 1);
  }
}

TEST(DrawnShapes, AModelWithoutVariationDrawsItsMean) {
  const TriangleSoup torus = testing::torus_soup(12, 8);
  const ShapeModel model(flattened(torus.points), Eigen::MatrixXd(3 * torus.points.size(), 0),
                         Eigen::VectorXd(0), torus.triangles);
  const DrawnShapes drawn = drawn_shapes(model, few, RunContext(1));
  EXPECT_EQ(drawn.draws.size(), 40u);
  EXPECT_EQ(drawn.self_intersecting.mean, 0);
  EXPECT_EQ(drawn.folded.mean, 0);
  EXPECT_EQ(drawn.opposing_mean.mean, 0);
}

TEST(DrawnShapes, CountsTheSelfIntersectionsOfEveryDraw) {
  const AlignedCohort aligned =
      align_cohort(testing::torus_cohort({.shapes = 5, .amplitude_mm = 6}), ScaleMode::keep);
  const DrawnShapes drawn = drawn_shapes(aligned.model, few, RunContext(2));
  int pairs = 0, intersecting = 0;
  for (std::size_t i = 0; i < drawn.draws.size(); ++i) {
    Rng rng = Rng(few.seed).fork(i);
    Eigen::VectorXd b(aligned.model.modes());
    for (Eigen::Index m = 0; m < b.size(); ++m) {
      double z = rng.normal();
      while (!(z >= -2 && z <= 2)) z = rng.normal();
      b[m] = z * std::sqrt(aligned.model.variance()[m]);
    }
    const Mesh mesh = build_mesh({unflattened(aligned.model.reconstruct(b)), aligned.model.triangles()});
    const auto expected = static_cast<int>(self_intersections(TriangleTree(mesh)).size());
    EXPECT_EQ(drawn.draws[i].self_intersections, expected);
    pairs += expected;
    intersecting += expected > 0;
  }
  EXPECT_GT(pairs, 0);
  EXPECT_LT(intersecting, few.draws);
  EXPECT_DOUBLE_EQ(drawn.self_intersecting.mean, static_cast<double>(intersecting) / few.draws);
}

TEST(DrawnShapes, ThreadsChangeNothing) {
  const AlignedCohort aligned =
      align_cohort(testing::torus_cohort({.shapes = 4, .amplitude_mm = 6}), ScaleMode::keep);
  const auto counts = [&](int threads) {
    std::vector<int> found;
    for (const DrawnShape& d : drawn_shapes(aligned.model, few, RunContext(threads)).draws)
      found.insert(found.end(), {d.self_intersections, d.folded, d.opposing_mean});
    return found;
  };
  EXPECT_EQ(counts(1), counts(4));
}

TEST(DrawnShapes, RefusesNoDrawsAndStopsWhenAsked) {
  EXPECT_THROW(drawn_shapes(square_with_moving_centre(), {.draws = 0}, RunContext(1)), InvalidInput);
  const RunContext ctx(1);
  ctx.request_stop();
  EXPECT_THROW(drawn_shapes(square_with_moving_centre(), few, ctx), Cancelled);
}

}  // namespace
}  // namespace foramen
