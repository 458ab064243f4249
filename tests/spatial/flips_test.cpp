#include "spatial/flips.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Not;

// A square with side `size` around the origin at height z, with `cells` cells per side, facing up or down.
TriangleSoup square(double size, int cells, double z, bool up) {
  TriangleSoup soup;
  for (int i = 0; i <= cells; ++i)
    for (int j = 0; j <= cells; ++j)
      soup.points.emplace_back(size * (i * 1.0 / cells - 0.5), size * (j * 1.0 / cells - 0.5), z);
  const auto id = [&](int i, int j) { return i * (cells + 1) + j; };
  const auto add = [&](int a, int b, int c) {
    soup.triangles.push_back(up ? std::array{a, b, c} : std::array{a, c, b});
  };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      add(id(i, j), id(i + 1, j), id(i + 1, j + 1));
      add(id(i, j), id(i + 1, j + 1), id(i, j + 1));
    }
  return soup;
}

// Both walls of a plate: the upper one at z = thickness / 2, facing up, the lower one facing down.
Mesh plate(double size, int cells, double thickness) {
  TriangleSoup soup = square(size, cells, thickness / 2, true);
  const TriangleSoup lower = square(size, cells, -thickness / 2, false);
  const int offset = static_cast<int>(soup.points.size());
  soup.points.insert(soup.points.end(), lower.points.begin(), lower.points.end());
  for (const auto& t : lower.triangles)
    soup.triangles.push_back({t[0] + offset, t[1] + offset, t[2] + offset});
  return build_mesh(std::move(soup));
}

// A torus with vertex 0 moved across the opposite side of its ring of neighbours, so that triangles there are
// flipped.
Mesh folded_torus(const Mesh& torus) {
  std::vector<Vec3> points(torus.positions().begin(), torus.positions().end());
  const std::vector<HalfedgeId> fan = torus.fan(VertexId(0));
  const Vec3 across = torus.position(torus.to(fan.front()));
  points[0] += 1.6 * (across - points[0]);
  return torus.with_positions(points);
}

TEST(SampledFlips, NoneOfASurfaceAgainstItself) {
  const Mesh mesh = build_mesh(testing::bumpy_torus_soup(40, 20, 1));
  const SampledFlips flips = sampled_flips(mesh, TriangleTree(mesh));
  EXPECT_THAT(flips.plain, IsEmpty());
  EXPECT_THAT(flips.confirmed, IsEmpty());
  EXPECT_THAT(flips.degenerate, IsEmpty());
}

TEST(SampledFlips, AllOfASurfaceTurnedInsideOut) {
  const Mesh mesh = build_mesh(testing::torus_soup(40, 20));
  const SampledFlips flips = sampled_flips(reversed(mesh), TriangleTree(mesh));
  EXPECT_EQ(flips.plain.size(), 1600u);
  EXPECT_EQ(flips.confirmed.size(), 1600u);
}

TEST(SampledFlips, APlantedFoldIsCountedPlainAndConfirmed) {
  const Mesh input = build_mesh(testing::torus_soup(80, 40)), folded = folded_torus(input);
  // The expected result: the triangles whose normal opposes their original normal.
  std::vector<FaceId> turned;
  for (FaceId f : input.faces())
    if (area_vector(input.triangle(f)).dot(area_vector(folded.triangle(f))) < 0) turned.push_back(f);
  ASSERT_FALSE(turned.empty());
  const SampledFlips flips = sampled_flips(folded, TriangleTree(input));
  EXPECT_EQ(flips.plain, turned);
  EXPECT_EQ(flips.confirmed, turned);
}

TEST(SampledFlips, OnAThinWallPlainFlipsAreNotConfirmed) {
  // Landmark triangles of edges about 1 mm that belong to the upper wall, but lie a little nearer to the
  // lower one.
  const TriangleTree thin(plate(20, 40, 0.2));
  const Mesh between = build_mesh(square(8, 8, -0.05, true));
  const SampledFlips flips = sampled_flips(between, thin);
  EXPECT_EQ(flips.plain.size(), between.face_count());
  EXPECT_THAT(flips.confirmed, IsEmpty());
  // On a thick plate, the same triangles are flips, because nothing near them faces up.
  const SampledFlips thick =
      sampled_flips(build_mesh(square(8, 8, -1.05, true)), TriangleTree(plate(20, 40, 2.2)));
  EXPECT_EQ(thick.confirmed.size(), between.face_count());
}

TEST(SampledFlips, TheMarginIsAQuarterOfTheMeanLandmarkEdge) {
  const Mesh landmarks = build_mesh(square(8, 8, -0.2, true));
  const double margin = 0.25 * mean_edge_length(landmarks);
  // The distance is d to the lower wall and d + excess to the upper wall. The flip is confirmed if the excess
  // is larger than the margin.
  const auto confirmed = [&](double excess) {
    const double d = 0.1, thickness = 2 * d + excess;
    const Mesh moved =
        transformed(landmarks, RigidTransform(Eigen::Translation3d(0, 0, 0.2 - thickness / 2 + d)));
    return sampled_flips(moved, TriangleTree(plate(20, 40, thickness))).confirmed.size();
  };
  EXPECT_EQ(confirmed(0.98 * margin), 0u);
  EXPECT_EQ(confirmed(1.02 * margin), landmarks.face_count());
}

TEST(SampledFlips, TrianglesWithoutAreaAreDegenerateAndNothingElse) {
  const Mesh input = build_mesh(testing::torus_soup(40, 20));
  std::vector<Vec3> points(input.positions().begin(), input.positions().end());
  const auto corners = input.corners(FaceId(7));
  points[corners[0].index] = 0.3 * input.position(corners[1]) + 0.7 * input.position(corners[2]);
  const SampledFlips flips = sampled_flips(input.with_positions(points), TriangleTree(input));
  EXPECT_THAT(flips.degenerate, ElementsAre(FaceId(7)));
  EXPECT_THAT(flips.plain, Not(Contains(FaceId(7))));
}

TEST(SampledFlips, UnchangedByAMotionOfBoth) {
  const Mesh input = build_mesh(testing::torus_soup(80, 40)), folded = folded_torus(input);
  const RigidTransform motion =
      Eigen::Translation3d(90, 10, -40) * Eigen::AngleAxisd(2, Vec3(0, 1, 3).normalized());
  const SampledFlips here = sampled_flips(folded, TriangleTree(input));
  const SampledFlips there =
      sampled_flips(transformed(folded, motion), TriangleTree(transformed(input, motion)));
  EXPECT_EQ(here.plain, there.plain);
  EXPECT_EQ(here.confirmed, there.confirmed);
}

TEST(OpposingMean, CountsTurnedTrianglesWhateverThePose) {
  const Mesh mean = build_mesh(testing::torus_soup(80, 40)), folded = folded_torus(mean);
  int turned = 0;
  for (FaceId f : mean.faces())
    if (area_vector(mean.triangle(f)).dot(area_vector(folded.triangle(f))) < 0) ++turned;
  ASSERT_GT(turned, 0);
  const RigidTransform motion =
      Eigen::Translation3d(90, 10, -40) * Eigen::AngleAxisd(3, Vec3(0, 1, 3).normalized());
  EXPECT_EQ(opposing_mean(folded, mean), turned);
  EXPECT_EQ(opposing_mean(transformed(folded, motion), mean), turned);
  EXPECT_EQ(opposing_mean(transformed(mean, motion), mean), 0);
}

TEST(OpposingMean, RefusesOtherTriangles) {
  EXPECT_THROW(opposing_mean(build_mesh(testing::torus_soup(10, 6)), build_mesh(testing::torus_soup(6, 10))),
               InvalidInput);
}

// A plane strip and the same strip rolled up. It is not folded over anywhere, but half of its triangles have
// opposite normals.
TEST(FoldedOver, APartThatTurnsAsAWholeIsNotFolded) {
  constexpr int length = 60, width = 4;
  constexpr double radius = length / 4.8;  // the strip covers an angle of 4.8 rad
  TriangleSoup flat, rolled;
  for (int i = 0; i <= length; ++i)
    for (int j = 0; j <= width; ++j) {
      flat.points.emplace_back(i, j, 0);
      rolled.points.emplace_back(radius * std::sin(i / radius), j, radius * (1 - std::cos(i / radius)));
    }
  const auto at = [](int i, int j) { return i * (width + 1) + j; };
  for (int i = 0; i < length; ++i)
    for (int j = 0; j < width; ++j) {
      flat.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      flat.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  const Mesh mean = build_mesh(flat), shape = mean.with_positions(rolled.points);
  EXPECT_GT(opposing_mean(shape, mean), 100);
  EXPECT_EQ(folded_over(shape, mean), 0);

  // Moving an inner vertex across the opposite edge of a triangle flips this triangle on both strips.
  for (std::vector<Vec3> points : {flat.points, rolled.points}) {
    const auto corner = [&](int i, int j) { return points[at(i, j)]; };
    const Vec3 middle = 0.5 * (corner(20, 2) + corner(21, 3));
    points[at(21, 2)] += 1.3 * (middle - corner(21, 2));
    EXPECT_EQ(folded_over(mean.with_positions(points), mean), 1);
  }
}

TEST(FoldedOver, CountsNothingThatIsFoldedInTheMeanToo) {
  const Mesh mean = build_mesh(testing::torus_soup(80, 40)), folded = folded_torus(mean);
  EXPECT_GT(folded_over(folded, mean), 0);
  EXPECT_EQ(folded_over(folded, folded), 0);
  EXPECT_THROW(folded_over(mean, build_mesh(testing::torus_soup(40, 80))), InvalidInput);
}

// Triangles that are collapsed to one of their sides have no normal. Rounding to single precision gives them
// an arbitrary normal.
TEST(SampledFlips, RoundingToSinglePrecisionTurnsNothingOver) {
  TriangleSoup soup = testing::torus_soup(60, 30);
  for (Vec3& p : soup.points) p = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()) * p + Vec3(31, -47, 90);
  const Mesh input = build_mesh(soup);
  const TriangleTree tree(input);
  std::vector<Vec3> collapsed(soup.points);
  for (std::size_t f = 0; f < soup.triangles.size(); f += 2 * 30 * 3 + 14) {
    const auto at = [&](std::size_t k) { return soup.triangles[f][k]; };
    collapsed[at(0)] = soup.points[at(1)] + 0.37 * (soup.points[at(2)] - soup.points[at(1)]);
  }
  for (Vec3& p : collapsed) p = p.cast<float>().cast<double>();
  const Mesh rounded = input.with_positions(collapsed);
  const SampledFlipsOptions from_file{single_precision_height(rounded)};
  EXPECT_THAT(sampled_flips(rounded, tree).plain, Not(IsEmpty()));
  EXPECT_THAT(sampled_flips(rounded, tree, from_file).plain, IsEmpty());
  EXPECT_THAT(sampled_flips(rounded, tree, from_file).degenerate, Not(IsEmpty()));

  const Mesh folded = folded_torus(input);
  EXPECT_EQ(sampled_flips(folded, tree, from_file).plain, sampled_flips(folded, tree).plain);
  EXPECT_THAT(sampled_flips(folded, tree, from_file).plain, Not(IsEmpty()));
}

}  // namespace
}  // namespace foramen
