#include "evaluate/mark_scatter.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace foramen {
namespace {

constexpr double square_side = 10;

Mesh square() {
  return build_mesh({{{0, 0, 0}, {square_side, 0, 0}, {square_side, square_side, 0}, {0, square_side, 0}},
                     {{0, 1, 2}, {0, 2, 3}}});
}

// The point (x, y) of the square, y <= x.
SurfacePoint at(double x, double y) {
  return {FaceId(0), {1 - x / square_side, (x - y) / square_side, y / square_side}};
}

PlacedMark line(int shape, double y, double shift = 0) {
  PlacedMark mark{"line", MarkKind::open_curve, shape, {}};
  for (int i = 0; i < 5; ++i) mark.places.push_back(at(4 + i + shift, y));
  return mark;
}

// The corners of a square, from its lower left one.
PlacedMark ring(int shape, double up) {
  PlacedMark mark{"ring", MarkKind::closed_curve, shape, {}};
  for (const auto& [x, y] : {std::pair(6, 2), {8, 2}, {8, 4}, {6, 4}}) mark.places.push_back(at(x, y + up));
  return mark;
}

TEST(MarkScatter, OfMarksAtOnePlaceIsZero) {
  std::vector<PlacedMark> placed;
  for (int s = 0; s < 3; ++s) {
    placed.push_back({"tip", MarkKind::point, s, {at(3, 2)}});
    placed.push_back(line(s, 1));
    placed.push_back(ring(s, 0));
  }
  const std::vector<MarkScatter> scatter = mark_scatter(square(), placed);
  ASSERT_EQ(scatter.size(), 3u);
  EXPECT_EQ(scatter[0].mark, "tip");
  EXPECT_EQ(scatter[1].placed.size(), 3u);
  EXPECT_EQ(scatter[2].kind, MarkKind::closed_curve);
  for (const MarkScatter& mark : scatter) EXPECT_LT(mark.rms, 1e-12) << mark.mark;
}

TEST(MarkScatter, OfPointsIsTheRootMeanSquareDistanceToTheirCentroid) {
  std::vector<PlacedMark> placed;
  for (const auto& [x, y] : {std::pair(5, 1), {7, 1}, {5, 3}, {7, 3}})
    placed.push_back({"tip", MarkKind::point, static_cast<int>(placed.size()), {at(x, y)}});
  const std::vector<MarkScatter> scatter = mark_scatter(square(), placed);
  EXPECT_LT((scatter.at(0).centre.at(0) - Vec3(6, 2, 0)).norm(), 1e-12);
  EXPECT_NEAR(scatter[0].rms, std::sqrt(2), 1e-12);
}

TEST(MarkScatter, OfParallelCurvesIsThatOfTheirDistances) {
  const std::vector<PlacedMark> placed{line(0, 0), line(2, 1), line(5, 3.5)};
  const double mean = 1.5, squares = std::pow(mean, 2) + std::pow(1 - mean, 2) + std::pow(3.5 - mean, 2);
  EXPECT_NEAR(mark_scatter(square(), placed).at(0).rms, std::sqrt(squares / 3), 1e-12);
}

TEST(MarkScatter, AlongACurveIsSeenAtItsEndsAlone) {
  // Two lines, half a step apart: the ends of the mean line are a quarter of a step from theirs.
  const std::vector<PlacedMark> placed{line(0, 1), line(1, 1, 0.5)};
  const double of_an_end = std::sqrt((std::pow(0.25, 2) + 0) / 2);
  EXPECT_NEAR(mark_scatter(square(), placed).at(0).rms, 2 * of_an_end / 5, 1e-12);
}

TEST(MarkScatter, OfRingsReachesOverTheirClosingSide) {
  // Half of the corners lie on the left and right sides of the mean square, of which the left one closes it.
  const std::vector<PlacedMark> placed{ring(0, 0.5), ring(1, -0.5)};
  EXPECT_NEAR(mark_scatter(square(), placed).at(0).rms, 0.5 / std::sqrt(2), 1e-12);
}

}  // namespace
}  // namespace foramen
