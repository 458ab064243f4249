#include "foramen/model/landmark_weights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using Shapes = std::vector<std::vector<Vec3>>;

const TriangleSoup& surface() {
  static const TriangleSoup soup = testing::bumpy_torus_soup(24, 12, 3);
  return soup;
}

std::vector<Vec3> posed(const std::vector<Vec3>& points, std::uint64_t seed) {
  Rng rng(seed);
  RigidTransform pose = RigidTransform::Identity();
  pose.linear() = Eigen::Quaterniond(rng.normal(), rng.normal(), rng.normal(), rng.normal())
                      .normalized()
                      .toRotationMatrix();
  pose.translation() = 100 * Vec3(rng.normal(), rng.normal(), rng.normal());
  return transformed(points, pose);
}

std::vector<double> area_weights(const Shapes& shapes, ScaleMode scale = ScaleMode::keep) {
  return landmark_weights(shapes, surface().triangles, scale, LandmarkWeights::area);
}

Shapes jittered(int count) {
  Rng rng(5);
  Shapes shapes;
  for (int s = 0; s < count; ++s) {
    shapes.push_back(surface().points);
    for (Vec3& p : shapes.back()) p += 0.3 * Vec3(rng.normal(), rng.normal(), rng.normal());
  }
  return shapes;
}

TEST(LandmarkWeights, EqualOnesAreNone) {
  EXPECT_TRUE(
      landmark_weights(jittered(3), surface().triangles, ScaleMode::keep, LandmarkWeights::equal).empty());
}

TEST(LandmarkWeights, AreTheAreasAroundLandmarksOfMeanOne) {
  const Shapes copies{posed(surface().points, 1), posed(surface().points, 2), posed(surface().points, 3)};
  const auto weights = area_weights(copies);
  std::vector<double> areas(surface().points.size(), 0.0);
  double total = 0;
  for (const auto& t : surface().triangles) {
    const auto corner = [&](std::size_t k) { return surface().points[t[k]]; };
    const double triangle = 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
    for (const int c : t) areas[c] += triangle / 3;
    total += triangle;
  }
  ASSERT_EQ(weights.size(), areas.size());
  const auto count = static_cast<double>(areas.size());
  for (std::size_t i = 0; i < areas.size(); ++i) EXPECT_NEAR(weights[i], count * areas[i] / total, 1e-9);
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), count, 1e-9);
}

TEST(LandmarkWeights, RigidMotionAndSizeOfAllChangeNothing) {
  const Shapes shapes = jittered(4);
  Shapes moved, larger = shapes;
  for (std::size_t s = 0; s < shapes.size(); ++s) moved.push_back(posed(shapes[s], 10 + s));
  for (auto& shape : larger)
    for (Vec3& p : shape) p *= 1.7;
  for (const ScaleMode scale : {ScaleMode::keep, ScaleMode::remove}) {
    const auto before = area_weights(shapes, scale);
    const auto turned = area_weights(moved, scale), grown = area_weights(larger, scale);
    for (std::size_t i = 0; i < before.size(); ++i) {
      EXPECT_NEAR(turned[i], before[i], 1e-7);
      EXPECT_NEAR(grown[i], before[i], 1e-9);
    }
  }
}

TEST(LandmarkWeights, RefusesALandmarkWithoutArea) {
  Shapes shapes = jittered(3);
  const auto& first = surface().triangles[0];
  for (auto& shape : shapes)  // the triangles around a vertex collapse to a point
    for (const auto& t : surface().triangles)
      if (std::find(t.begin(), t.end(), first[0]) != t.end())
        for (const int c : t) shape[c] = Vec3(1, 2, 3);
  EXPECT_THROW(area_weights(shapes), InvalidInput);
  EXPECT_EQ(word_of(LandmarkWeights::equal), "equal");
  EXPECT_EQ(word_of(LandmarkWeights::area), "area");
}

}  // namespace
}  // namespace foramen
