#include "render/vertebra_scenes.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "render/in_picture.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen {
namespace {

using testing::in_picture;
using testing::lopsided_torus_soup;

TEST(Frame, ShowsAllPointsAndLittleMore) {
  const TriangleSoup soup = lopsided_torus_soup(30, 16, 0.9);
  const Camera camera = frame(soup.points, {1, -2, 0.5}, {0, 0, 1});
  double right = 0, up = 0;
  for (const Vec3& p : soup.points) {
    right = std::max(right, std::abs(in_picture(camera, p).x()));
    up = std::max(up, std::abs(in_picture(camera, p).y()));
  }
  EXPECT_LT(2 * right, camera.width_mm);
  EXPECT_LT(2 * up, camera.height_mm);
  EXPECT_GT(2 * right, 0.9 * camera.width_mm);
  EXPECT_GT(2 * up, 0.9 * camera.height_mm);
}

TEST(ViewOf, ARigidMotionChangesNothingInThePicture) {
  const TriangleSoup soup = lopsided_torus_soup(30, 16, 0.9);
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(2.1, Vec3(1, -1, 3).normalized())).pretranslate(Vec3(40, 2, -7));
  const auto moved = transformed(soup.points, motion);
  for (View view : {View::along_shortest, View::along_middle, View::along_longest}) {
    const Camera before = view_of(soup.points, view, soup.points), after = view_of(moved, view, moved);
    EXPECT_NEAR(before.width_mm, after.width_mm, 1e-9);
    EXPECT_NEAR(before.height_mm, after.height_mm, 1e-9);
    for (std::size_t i = 0; i < moved.size(); ++i)
      EXPECT_NEAR((in_picture(before, soup.points[i]) - in_picture(after, moved[i])).norm(), 0, 1e-9);
  }
}

TEST(MarkedSurface, TwoColoursOfTriangles) {
  const SceneSurface surface = marked_surface(testing::torus_soup(8, 6), {3, 5}, SurfaceStyle::facets);
  int red = 0;
  for (const Colour& c : surface.face_colours) red += c[0] > 2 * c[1];
  EXPECT_EQ(red, 2);
  EXPECT_EQ(surface.face_colours[3], surface.face_colours[5]);
}

TEST(ThreeViews, AreAtOneScaleAndShowTheContents) {
  const TriangleSoup soup = lopsided_torus_soup(30, 16, 0.9);
  Scene contents;
  contents.surfaces.emplace_back().soup = soup;
  const std::vector<Scene> views = three_views(soup.points, contents);
  ASSERT_EQ(views.size(), 3u);
  for (const Scene& view : views) {
    EXPECT_EQ(view.surfaces.size(), 1u);
    EXPECT_EQ(view.camera.height_mm, views[0].camera.height_mm);
    for (const Vec3& p : soup.points) {
      EXPECT_LT(std::abs(in_picture(view.camera, p).x()), view.camera.width_mm / 2);
      EXPECT_LT(std::abs(in_picture(view.camera, p).y()), view.camera.height_mm / 2);
    }
  }
  EXPECT_LT(std::abs(views[0].camera.direction.dot(views[1].camera.direction)), 1e-9);
}

}  // namespace
}  // namespace foramen
