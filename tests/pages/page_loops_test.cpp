#include "pages/page_loops.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "support/torus_family.hpp"

namespace foramen {
namespace {

using Loops = std::array<std::vector<SurfacePoint>, 2>;

constexpr double major = 20, minor = 8;

// The point of a torus about the z axis that is closest to p.
SurfacePoint on(const Mesh& mesh, const Vec3& p) {
  SurfacePoint best;
  double least = 1e300;
  for (FaceId f : mesh.faces()) {
    const auto t = mesh.triangle(f);
    const double d = ((t[0] + t[1] + t[2]) / 3 - p).norm();
    if (d < least) {
      least = d;
      best = {f, Vec3::Constant(1.0 / 3)};
    }
  }
  return best;
}

std::vector<SurfacePoint> around_the_hole(const Mesh& mesh) {
  std::vector<SurfacePoint> loop;
  for (int i = 0; i < 40; ++i) {
    const double angle = i * std::numbers::pi / 20;
    loop.push_back(on(mesh, (major - minor) * Vec3(std::cos(angle), std::sin(angle), 0)));
  }
  return loop;
}

std::vector<SurfacePoint> around_the_tube(const Mesh& mesh) {
  std::vector<SurfacePoint> loop;
  for (int i = 0; i < 20; ++i) {
    const double angle = i * std::numbers::pi / 10;
    loop.push_back(on(mesh, {major + minor * std::cos(angle), 0, minor * std::sin(angle)}));
  }
  return loop;
}

void expect_right_angles(const std::vector<PageView>& views) {
  for (const PageView& view : views) {
    EXPECT_NEAR(view.from.norm(), 1, 1e-12) << view.name;
    EXPECT_NEAR(view.up.norm(), 1, 1e-12) << view.name;
    EXPECT_NEAR(view.from.dot(view.up), 0, 1e-12) << view.name;
  }
}

// A torus whose front is thicker, like the body of a vertebra.
Mesh torus_with_body() {
  TriangleSoup soup = testing::torus_soup(60, 24, major, minor);
  for (Vec3& p : soup.points)
    if (p.y() > 0 && p.head<2>().norm() > major) p.y() *= 1.4;
  return build_mesh(soup);
}

TEST(PageViews, TheCanalIsLookedThrough) {
  const Mesh mesh = torus_with_body();
  for (const Loops& loops : {Loops{around_the_hole(mesh), around_the_tube(mesh)},
                             Loops{around_the_tube(mesh), around_the_hole(mesh)}}) {
    const auto views = page_views(mesh, loops);
    ASSERT_EQ(views.size(), 5u);
    expect_right_angles(views);
    EXPECT_EQ(views[1].name, "Along the canal");
    EXPECT_NEAR(views[1].from.z(), -1, 1e-3) << "from below";
    EXPECT_NEAR(views[1].up.y(), 1, 1e-2) << "the body is at the top";
    EXPECT_EQ(views[3].name, "Back");
    EXPECT_NEAR(views[3].from.y(), -1, 1e-2);
    EXPECT_NEAR(views[3].up.z(), 1, 1e-3) << "the head is up";
  }
}

TEST(PageViews, WithoutOneLoopAroundTheCanalThePrincipalAxesAreTaken) {
  const Mesh mesh = torus_with_body();
  for (const Loops& loops : {Loops{around_the_hole(mesh), around_the_hole(mesh)},
                             Loops{around_the_tube(mesh), around_the_tube(mesh)}}) {
    const auto views = page_views(mesh, loops);
    ASSERT_EQ(views.size(), 3u);
    expect_right_angles(views);
    EXPECT_NEAR(std::abs(views[0].from.z()), 1, 1e-3) << "the shortest axis of a torus is its own";
  }
}

TEST(LoopsOnLandmarks, LieWhereTheTemplatesLoopsLie) {
  BuildOptions options = testing::small();
  options.correspondence.group.round_limit = 0;
  options.landmarks.count = 600;
  options.landmarks.spread.density_updates = 0;
  const BuiltModel built = build_model(testing::family(), options, RunContext(2));
  const Atlas atlas = atlas_of(built);
  const Mesh landmarks =
      build_mesh({built.landmarks.points[built.registration.reference], built.landmarks.mesh.triangles});
  const Loops loops = loops_on_landmarks(atlas);
  for (std::size_t k = 0; k < 2; ++k) {
    ASSERT_EQ(loops[k].size(), atlas.loops[k].size());
    for (std::size_t i = 0; i < loops[k].size(); ++i)
      EXPECT_LT((position(landmarks, loops[k][i]) - atlas.surface.position(atlas.loops[k][i])).norm(),
                mean_edge_length(landmarks));
  }
}

}  // namespace
}  // namespace foramen
