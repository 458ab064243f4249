#include "render/close_up.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "render/in_picture.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using testing::in_picture;

constexpr int around = 80, tube = 40;

// The first triangle of the quad at these steps about the axis and about the tube.
int triangle_at(int i, int j) { return 2 * (i * tube + j); }

// Marked triangles: a patch on top of the tube, a quarter turn round the ring, and single triangles
// elsewhere.
std::vector<int> scattered_and_a_patch() {
  std::vector<int> marked;
  for (int i = 0; i < around; i += 8) marked.push_back(triangle_at(i, 0));
  for (int i = 18; i < 22; ++i)
    for (int j = 8; j < 12; ++j)
      for (int k = 0; k < 2; ++k) marked.push_back(triangle_at(i, j) + k);
  return marked;
}

TEST(CloseUp, LooksFromOutsideAtTheDensestMarks) {
  const TriangleSoup soup = testing::torus_soup(around, tube);
  const Camera camera = close_up(soup, scattered_and_a_patch(), {.size_mm = 10, .pixel_mm = 0.25});
  EXPECT_EQ(camera.width_mm, 10);
  EXPECT_EQ(camera.height_mm, 10);
  EXPECT_LT(camera.direction.z(), -0.8);  // the patch faces upward
  const Vec2 place = in_picture(camera, Vec3(0, 20, 8));
  EXPECT_LT(std::max(std::abs(place.x()), std::abs(place.y())), 5);
}

// A torus of marked triangles inside the tube changes nothing, because it is hidden.
TEST(CloseUp, WhatIsHiddenDoesNotCount) {
  TriangleSoup soup = testing::torus_soup(around, tube);
  std::vector<int> marked = scattered_and_a_patch();
  const CloseUpOptions options{.size_mm = 10, .pixel_mm = 0.25};
  const Camera before = close_up(soup, marked, options);
  const TriangleSoup inner = testing::torus_soup(around, tube, 20, 6);
  const int offset = static_cast<int>(soup.points.size());
  soup.points.insert(soup.points.end(), inner.points.begin(), inner.points.end());
  for (const auto& t : inner.triangles) {
    marked.push_back(static_cast<int>(soup.triangles.size()));
    soup.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  }
  const Camera after = close_up(soup, marked, options);
  EXPECT_EQ(before.centre, after.centre);
  EXPECT_EQ(before.direction, after.direction);
}

// A triangle that is divided into sixty slivers does not outweigh the patch.
TEST(CloseUp, AreaCountsAndNotTheNumberOfTriangles) {
  TriangleSoup soup = testing::torus_soup(around, tube);
  std::vector<int> marked = scattered_and_a_patch();
  const CloseUpOptions options{.size_mm = 10, .pixel_mm = 0.25};
  const Camera before = close_up(soup, marked, options);
  const int split = triangle_at(0, 0);  // a scattered one
  std::array<int, 3> t = soup.triangles[split];
  for (int k = 0; k < 60; ++k) {  // cut off one corner after the other, along a line to the middle of an edge
    const int middle = static_cast<int>(soup.points.size());
    soup.points.emplace_back((soup.points[t[1]] + soup.points[t[2]]) / 2);
    marked.push_back(static_cast<int>(soup.triangles.size()));
    soup.triangles.push_back({t[0], t[1], middle});
    t = {t[0], middle, t[2]};
  }
  soup.triangles[split] = t;
  const Camera after = close_up(soup, marked, options);
  EXPECT_EQ(before.centre, after.centre);
  EXPECT_EQ(before.direction, after.direction);
}

}  // namespace
}  // namespace foramen
