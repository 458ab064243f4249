#include "extract/smooth_surface.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "foramen/core/rng.hpp"
#include "spatial/self_intersections.hpp"
#include "support/meshes.hpp"

namespace foramen::extract {
namespace {

// A torus whose vertices are off by as much as the steps of voxels are.
TriangleSoup rough_torus() {
  TriangleSoup soup = testing::torus_soup(60, 24, 12, 5);
  Rng rng(4);
  for (Vec3& p : soup.points) p += 0.15 * Vec3(rng.normal(), rng.normal(), rng.normal());
  return soup;
}

double volume_of(const TriangleSoup& soup, const std::vector<Vec3>& points) {
  return signed_volume(build_mesh({points, soup.triangles}));
}

// How far vertices are from the middle of their neighbours, RMS.
double roughness(const TriangleSoup& soup, const std::vector<Vec3>& points) {
  const Mesh mesh = build_mesh({points, soup.triangles});
  double sum = 0;
  for (VertexId v : mesh.vertices()) {
    Vec3 middle = Vec3::Zero();
    int count = 0;
    for (HalfedgeId h : mesh.fan(v)) middle += mesh.position(mesh.to(h)), ++count;
    sum += (middle / count - mesh.position(v)).squaredNorm();
  }
  return std::sqrt(sum / mesh.vertex_count());
}

TEST(SmoothSurface, IsSmootherEnclosesTheVolumeAndKeepsEveryVertexWithinTheBound) {
  const TriangleSoup rough = rough_torus();
  const Vec3 spacing(0.5, 0.5, 1);
  constexpr double bound = 0.9;  // voxels
  const double volume = 0.98 * volume_of(rough, rough.points);
  const SmoothedSurface smooth = smooth_surface(rough, spacing, volume, 15, bound);
  ASSERT_EQ(smooth.points.size(), rough.points.size());
  EXPECT_NEAR(volume_of(rough, smooth.points), volume, 1e-3 * volume);
  EXPECT_LT(roughness(rough, smooth.points), 0.6 * roughness(rough, rough.points));
  for (std::size_t i = 0; i < rough.points.size(); ++i)
    EXPECT_LE((smooth.points[i] - rough.points[i]).cwiseQuotient(spacing).norm(), bound + 1e-9);
  EXPECT_TRUE(self_intersections(TriangleTree(build_mesh({smooth.points, rough.triangles}))).empty());
}

TEST(SmoothSurface, WithoutRoundsNothingMoves) {
  const TriangleSoup rough = rough_torus();
  const double volume = 0.98 * volume_of(rough, rough.points);
  EXPECT_EQ(smooth_surface(rough, Vec3::Ones(), volume, 0, 1).points, rough.points);
}

}  // namespace
}  // namespace foramen::extract
