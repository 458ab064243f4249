#include "foramen/spatial/surface_distance.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using std::numbers::pi;

// A rectangle [0, width] x [0, 1] at height z, in `columns` columns of two triangles.
Mesh sheet(double width, double z, int columns = 4) {
  TriangleSoup soup;
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j < 2; ++j) soup.points.emplace_back(width * i / columns, j, z);
  for (int i = 0; i < columns; ++i) {
    soup.triangles.push_back({2 * i, 2 * i + 2, 2 * i + 3});
    soup.triangles.push_back({2 * i, 2 * i + 3, 2 * i + 1});
  }
  return build_mesh(std::move(soup));
}

TEST(SampleSurface, OnePointPerEqualShareOfTheArea) {
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(20, 12, 1));
  const int count = 977;
  const auto points = sample_surface(mesh, count, Rng(5));
  ASSERT_EQ(points.size(), 977u);
  FaceMap<int> hits(mesh.face_count(), 0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    ++hits[points[i].face];
    EXPECT_NEAR(points[i].barycentric.sum(), 1, 1e-12);
    EXPECT_GE(points[i].barycentric.minCoeff(), 0);
    EXPECT_LE(points[i > 0 ? i - 1 : 0].face, points[i].face);
  }
  // A face contains whole shares, except for one at each end.
  const double share = total_area(mesh) / count;
  for (FaceId f : mesh.faces()) EXPECT_NEAR(hits[f], area(mesh.triangle(f)) / share, 2);
}

TEST(SampleSurface, UniformWithinTheTriangles) {
  const Mesh mesh = sheet(3, 0, 1);
  Vec3 sum = Vec3::Zero(), squares = Vec3::Zero();
  const auto points = sample_surface(mesh, 20000, Rng(6));
  for (const auto& p : points) {
    sum += position(mesh, p);
    squares += position(mesh, p).cwiseAbs2();
  }
  EXPECT_LT((sum / 20000 - Vec3(1.5, 0.5, 0)).norm(), 0.02);
  EXPECT_LT((squares / 20000 - Vec3(3, 1.0 / 3, 0)).norm(), 0.06);  // width^2 / 3
}

TEST(SampleSurface, FacesWithoutAreaAreNeverTaken) {
  TriangleSoup soup = sheet(4, 0).soup();
  soup.points[0] = soup.points[1];  // the first two faces lose their area or change it
  soup.points[8] = soup.points[9];  // the last two as well
  const Mesh mesh = build_mesh(std::move(soup));
  for (const auto& p : sample_surface(mesh, 500, Rng(7))) EXPECT_GT(area(mesh.triangle(p.face)), 0);
  EXPECT_THROW(sample_surface(Mesh(), 3, Rng(1)), InvalidInput);
  EXPECT_THROW(sample_surface(mesh, -1, Rng(1)), InvalidInput);
}

TEST(SampleSurface, TheGeneratorIsLeftAsItWas) {
  const Mesh mesh = sheet(2, 0);
  const Rng rng(8);
  const auto a = sample_surface(mesh, 10, rng), b = sample_surface(mesh, 10, rng);
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].barycentric, b[i].barycentric);
}

TEST(SurfaceDistance, ParallelSheets) {
  const TriangleTree low(sheet(5, 0)), high(sheet(5, 3, 7));
  const SurfaceDistance d = surface_distance(low, high, {.samples = 1000});
  EXPECT_NEAR(d.mean, 3, 1e-12);
  EXPECT_NEAR(d.p95, 3, 1e-12);
  EXPECT_NEAR(d.hausdorff, 3, 1e-12);
}

TEST(SurfaceDistance, ASheetAndItsHalf) {
  // From the whole to the half, the distance is 0 over one half and x - 2 beyond. In the other direction it
  // is 0 everywhere.
  const TriangleTree whole(sheet(4, 0)), half(sheet(2, 0));
  const SurfaceDistance d = surface_distance(whole, half, {.samples = 20000});
  EXPECT_NEAR(d.mean, 0.5 * (0.5 * 1.0), 1e-3);  // average of two means: (0.5 * 1 + 0) / 2
  EXPECT_NEAR(d.p95, 1.6, 1e-2);       // 5 % of both sets: the last tenth of the whole sheet, x >= 3.6
  EXPECT_NEAR(d.hausdorff, 2, 1e-12);  // reached at vertices only
}

TEST(SurfaceDistance, ConcentricTori) {
  const double gap = 1.5;
  const TriangleTree inner(build_mesh(testing::torus_soup(160, 80, 20, 6)));
  const TriangleTree outer(build_mesh(testing::torus_soup(160, 80, 20, 6 + gap)));
  const double sagitta = 7.5 * (1 - std::cos(pi / 80)) + 27.5 * (1 - std::cos(pi / 160));
  const SurfaceDistance d = surface_distance(inner, outer, {.samples = 2000});
  EXPECT_NEAR(d.mean, gap, sagitta);
  EXPECT_NEAR(d.p95, gap, sagitta);
  EXPECT_NEAR(d.hausdorff, gap, sagitta);
  EXPECT_LE(d.mean, d.hausdorff);
}

TEST(SurfaceDistance, VerticesCountForHausdorff) {
  // A spike that probably no sample hits.
  TriangleSoup soup = testing::torus_soup(60, 40);
  const TriangleTree smooth(build_mesh(soup));
  soup.points[0] += Vec3(5, 0, 0);
  const TriangleTree spiked(build_mesh(std::move(soup)));
  EXPECT_NEAR(surface_distance(smooth, spiked, {.samples = 10}).hausdorff, 5, 1e-9);
}

TEST(SurfaceDistance, SymmetricToTheLastBit) {
  const TriangleTree a(build_mesh(testing::bumpy_torus_soup(30, 16, 1)));
  const TriangleTree b(build_mesh(testing::bumpy_torus_soup(25, 19, 2)));
  const SurfaceDistance ab = surface_distance(a, b, {.samples = 3000}),
                        ba = surface_distance(b, a, {.samples = 3000});
  EXPECT_EQ(ab.mean, ba.mean);
  EXPECT_EQ(ab.p95, ba.p95);
  EXPECT_EQ(ab.hausdorff, ba.hausdorff);
  EXPECT_GT(ab.mean, 0.1);
}

TEST(SurfaceDistance, HausdorffIsTheLargestOverSamplesAndVertices) {
  const Mesh a = build_mesh(testing::bumpy_torus_soup(20, 12, 3)),
             b = build_mesh(testing::bumpy_torus_soup(20, 12, 4));
  const TriangleTree tree_a(a), tree_b(b);
  const auto samples_a = sample_surface(a, 500, Rng(1)), samples_b = sample_surface(b, 500, Rng(2));
  double largest = 0;
  const auto raise = [&](const Vec3& p, const TriangleTree& to) {
    largest = std::max(largest, std::sqrt(to.closest(p).squared_distance));
  };
  for (const auto& p : samples_a) raise(position(a, p), tree_b);
  for (const auto& p : samples_b) raise(position(b, p), tree_a);
  for (const Vec3& p : a.positions()) raise(p, tree_b);
  for (const Vec3& p : b.positions()) raise(p, tree_a);
  EXPECT_EQ(surface_distance(tree_a, samples_a, tree_b, samples_b).hausdorff, largest);
}

TEST(SurfaceDistance, ZeroToItselfAndRefusedWithoutSamples) {
  const TriangleTree tree(build_mesh(testing::torus_soup(20, 10)));
  EXPECT_LT(surface_distance(tree, tree, {.samples = 500}).hausdorff, 1e-12);
  EXPECT_THROW(surface_distance(tree, tree, {.samples = 0}), InvalidInput);
}

TEST(SurfaceDistance, UnchangedByAMotionOfBoth) {
  const Mesh a = build_mesh(testing::bumpy_torus_soup(20, 12, 3)),
             b = build_mesh(testing::bumpy_torus_soup(20, 12, 4));
  const RigidTransform motion =
      Eigen::Translation3d(-50, 10, 400) * Eigen::AngleAxisd(2, Vec3(0, 1, 3).normalized());
  const SurfaceDistance here = surface_distance(TriangleTree(a), TriangleTree(b));
  const SurfaceDistance there =
      surface_distance(TriangleTree(transformed(a, motion)), TriangleTree(transformed(b, motion)));
  EXPECT_NEAR(here.mean, there.mean, 1e-9);
  EXPECT_NEAR(here.p95, there.p95, 1e-9);
  EXPECT_NEAR(here.hausdorff, there.hausdorff, 1e-9);
}

}  // namespace
}  // namespace foramen
