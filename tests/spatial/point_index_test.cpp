#include "spatial/point_index.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"

namespace foramen {
namespace {

Vec3 random_point(Rng& rng, double size) {
  return {rng.uniform(-size, size), rng.uniform(-size, size), rng.uniform(-size, size)};
}

std::vector<Vec3> random_points(int count, std::uint64_t seed) {
  Rng rng(seed);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i) points.push_back(random_point(rng, 10));
  return points;
}

std::vector<Vec3> random_normals(int count, std::uint64_t seed) {
  std::vector<Vec3> normals = random_points(count, seed);
  for (Vec3& n : normals) n.normalize();
  return normals;
}

// Points with integer coordinates, so that distances are exact and many are equal.
std::vector<Vec3> grid(int side) {
  std::vector<Vec3> points;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      for (int k = 0; k < side; ++k) points.emplace_back(i, j, k);
  return points;
}

// All points, sorted by distance and then by index.
template <class SquaredDistance>
std::vector<NearPoint> all_by_distance(int count, const SquaredDistance& squared_distance) {
  std::vector<NearPoint> all;
  for (int i = 0; i < count; ++i) all.push_back({i, squared_distance(static_cast<std::size_t>(i))});
  std::stable_sort(all.begin(), all.end(), [](const NearPoint& a, const NearPoint& b) {
    return a.squared_distance < b.squared_distance;
  });
  return all;
}

void expect_same(const std::vector<NearPoint>& found, const std::vector<NearPoint>& expected, int count) {
  ASSERT_EQ(found.size(), count);
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].index, expected[i].index) << "neighbour " << i;
    EXPECT_NEAR(found[i].squared_distance, expected[i].squared_distance, 1e-12);
  }
}

TEST(PointIndex, FindsWhatBruteForceFinds) {
  const auto points = random_points(500, 1);
  const PointIndex index(points);
  for (const Vec3& query : random_points(200, 2)) {
    const auto expected =
        all_by_distance(500, [&](std::size_t i) { return (points[i] - query).squaredNorm(); });
    EXPECT_EQ(index.nearest(query).index, expected[0].index);
    expect_same(index.nearest(query, 12), expected, 12);
  }
}

TEST(PointIndex, EqualDistancesGoToTheSmallerIndex) {
  const auto points = grid(6);
  const PointIndex index(points);
  for (const Vec3& corner : grid(5)) {
    const Vec3 query = corner + Vec3::Constant(0.5);  // eight points have the same distance
    const auto expected =
        all_by_distance(216, [&](std::size_t i) { return (points[i] - query).squaredNorm(); });
    EXPECT_EQ(index.nearest(query).index, expected[0].index);
    for (int count : {1, 3, 8, 20}) expect_same(index.nearest(query, count), expected, count);
  }
}

TEST(PointIndex, CoincidentPointsComeInOrder) {
  const std::vector<Vec3> points(50, Vec3(1, 2, 3));
  const PointIndex index(points);
  EXPECT_EQ(index.nearest(Vec3::Zero()).index, 0);
  const auto found = index.nearest(Vec3::Zero(), 50);
  ASSERT_EQ(found.size(), 50u);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(found[i].index, i);
}

TEST(PointIndex, FewOrNoPoints) {
  const PointIndex none{std::span<const Vec3>()};
  EXPECT_EQ(none.nearest(Vec3::Zero()).index, -1);
  EXPECT_TRUE(none.nearest(Vec3::Zero(), 3).empty());
  const std::vector<Vec3> two{Vec3(1, 0, 0), Vec3(0, 0, 0)};
  const PointIndex index(two);
  EXPECT_EQ(index.nearest(Vec3::Zero(), 5).size(), 2u);
  EXPECT_TRUE(index.nearest(Vec3::Zero(), 0).empty());
}

TEST(PointIndex, AnswersAfterItWasMoved) {
  const auto points = random_points(100, 3);
  PointIndex a(points);
  const int expected = a.nearest(Vec3::Zero()).index;
  PointIndex b(std::move(a));
  EXPECT_EQ(b.nearest(Vec3::Zero()).index, expected);
}

TEST(OrientedPointIndex, FindsWhatBruteForceFinds) {
  const double weight = 8;
  const auto points = random_points(500, 4), normals = random_normals(500, 5);
  const OrientedPointIndex index(points, normals, weight);
  const auto queries = random_points(200, 6), directions = random_normals(200, 7);
  for (std::size_t q = 0; q < queries.size(); ++q) {
    const auto expected = all_by_distance(500, [&](std::size_t i) {
      return (points[i] - queries[q]).squaredNorm() +
             weight * weight * (normals[i] - directions[q]).squaredNorm();
    });
    EXPECT_EQ(index.nearest(queries[q], directions[q]).index, expected[0].index);
    const auto found = index.nearest(queries[q], directions[q], 5);
    ASSERT_EQ(found.size(), 5u);
    for (std::size_t i = 0; i < 5; ++i) {
      EXPECT_EQ(found[i].index, expected[i].index);
      EXPECT_NEAR(found[i].squared_distance, expected[i].squared_distance, 1e-10);
    }
  }
}

TEST(OrientedPointIndex, TellsTheWallsOfAThinPlateApart) {
  const std::vector<Vec3> points{Vec3(0, 0, 0.2), Vec3(0, 0, -0.2)}, normals{Vec3::UnitZ(), -Vec3::UnitZ()};
  const Vec3 below_the_upper_wall(0, 0, -0.15);
  EXPECT_EQ(PointIndex(points).nearest(below_the_upper_wall).index, 1);
  EXPECT_EQ(OrientedPointIndex(points, normals, 8).nearest(below_the_upper_wall, Vec3::UnitZ()).index, 0);
  EXPECT_EQ(OrientedPointIndex(points, normals, 0).nearest(below_the_upper_wall, Vec3::UnitZ()).index, 1);
}

TEST(OrientedPointIndex, RefusesNormalsThatDoNotFitThePoints) {
  const auto points = random_points(3, 8), normals = random_normals(2, 9);
  EXPECT_THROW(OrientedPointIndex(points, normals, 8), InvalidInput);
  EXPECT_THROW(OrientedPointIndex(points, points, -1), InvalidInput);
}

}  // namespace
}  // namespace foramen
