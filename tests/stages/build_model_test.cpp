#include "foramen/pipeline/build_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "pipeline/torus_family.hpp"

namespace foramen {
namespace {

using testing::family;
using ::testing::HasSubstr;
using testing::shape;
using testing::small;

TEST(BuildModel, LandmarksLieOnEveryInputAndNoTriangleIsFlipped) {
  const ModelBuild build = build_model(family(), small(), RunContext(2));
  ASSERT_EQ(build.shapes.size(), 4u);
  EXPECT_EQ(build.remaining_flips, 0);
  for (const ShapeOutcome& outcome : build.shapes) {
    SCOPED_TRACE(outcome.input.stem);
    EXPECT_TRUE(outcome.registration.shape_map.certificate.valid());
    EXPECT_EQ(outcome.registration.shape_map.map.jumps.size(), 0) << "a map is not held beyond its use";
    ASSERT_EQ(outcome.landmarks.size(), build.landmarks.turns.size());
    const TriangleTree tree(outcome.input.mesh);
    for (const Vec3& p : outcome.landmarks) EXPECT_LT(tree.closest(p).squared_distance, 1e-12);
    const Mesh corresponding = build_mesh({outcome.landmarks, build.landmarks.triangles});
    EXPECT_EQ(corresponding.euler_characteristic(), 0);
    // Landmarks lie on the surface, so the chords cut off about h^2 / (6 r^2) = 2 % of a tube of radius r.
    EXPECT_NEAR(signed_volume(corresponding) / signed_volume(outcome.input.mesh), 1, 0.05);
  }
  EXPECT_GT(build.reference_map.shape_map.map.jumps.size(), 0);
  EXPECT_GT(build.model.variance()[0], 0.6 * build.model.variance().sum()) << "one bump varies";
}

TEST(BuildModel, TheBaselineTakesTheSameReferenceAndNumberOfLandmarks) {
  BuildOptions options = small();
  options.correspondence.method = Method::icp;
  const ModelBuild build = build_model(family(), options, RunContext(2));
  EXPECT_EQ(build.landmarks.turns.size(), 1200u);
  for (const ShapeOutcome& outcome : build.shapes) {
    const TriangleTree tree(outcome.input.mesh);
    for (const Vec3& p : outcome.landmarks) EXPECT_LT(tree.closest(p).squared_distance, 1e-12);
  }
}

TEST(BuildModel, FewerThanThreeShapesAreRefusedWithWhatWasLeftOut) {
  Cohort cohort = family();
  cohort.shapes.resize(2);
  cohort.left_out.push_back({"bad", "bad.ply", "", "genus 3"});
  try {
    build_model(std::move(cohort), small(), RunContext(1));
    FAIL() << "not refused";
  } catch (const InvalidInput& e) {
    EXPECT_THAT(e.what(), HasSubstr("at least 3"));
    EXPECT_THAT(e.what(), HasSubstr("bad.ply: genus 3"));
  }
}

TEST(BuildModel, AnUnknownReferenceIsRefused) {
  BuildOptions options = small();
  options.correspondence.reference = "nobody";
  EXPECT_THROW(build_model(family(), options, RunContext(1)), InvalidInput);
}

// A needle of ever smaller triangles about a triangle of the surface: a surface like any other, but its
// harmonic map shrinks the needle's tip to nothing.
TriangleSoup with_needle(TriangleSoup soup) {
  const std::array<int, 3> base = soup.triangles.back();
  soup.triangles.pop_back();
  std::array<Vec3, 3> corners;
  for (std::size_t m = 0; m < 3; ++m) corners[m] = soup.points[static_cast<std::size_t>(base[m])];
  const Vec3 step = 0.01 * unit_normal(corners), centre = (corners[0] + corners[1] + corners[2]) / 3;
  constexpr int rings = 60;
  std::array<int, 3> below = base;
  for (int r = 1; r <= rings; ++r) {
    std::array<int, 3> ring{};
    for (std::size_t m = 0; m < 3; ++m) {
      ring[m] = static_cast<int>(soup.points.size());
      soup.points.push_back(centre + 0.5 * (corners[m] - centre) + r * step);
    }
    for (std::size_t m = 0; m < 3; ++m) {
      const std::size_t n = (m + 1) % 3;
      soup.triangles.push_back({below[m], below[n], ring[n]});
      soup.triangles.push_back({below[m], ring[n], ring[m]});
    }
    below = ring;
  }
  soup.triangles.push_back(below);
  return soup;
}

TEST(BuildModel, AnOrdinaryShapeThatHasNoMapIsNotTheReference) {
  Cohort cohort = family();
  const int first = rank_references(cohort.shapes).front();
  InputShape& ragged = cohort.shapes[static_cast<std::size_t>(first)];
  ragged.mesh = build_mesh(with_needle(ragged.mesh.soup()));
  ASSERT_EQ(rank_references(cohort.shapes).front(), first) << "the needle weighs nothing";
  const std::string name = ragged.file_name;
  BuildOptions options = small();
  options.correspondence.method = Method::icp;
  options.landmarks.count = 200;
  const ModelBuild build = build_model(std::move(cohort), options, RunContext(2));
  EXPECT_THAT(build.notes, ::testing::ElementsAre(HasSubstr(name + " cannot be the reference")));
  EXPECT_GE(build.shapes.size(), 3u);
  EXPECT_NE(build.shapes[static_cast<std::size_t>(build.reference)].input.file_name, name);
}

TEST(RankReferences, BeginsWithTheShapeOfMedianSize) {
  std::vector<InputShape> shapes;
  for (double size : {1.3, 0.8, 1.0, 1.1, 0.5}) {
    TriangleSoup soup = testing::torus_soup(16, 10);
    for (Vec3& p : soup.points) p *= size;
    shapes.push_back(shape("x", soup));
  }
  EXPECT_THAT(rank_references(shapes), ::testing::ElementsAre(2, 3, 1, 0, 4));
}

TEST(RankReferences, EndsWithWhatTakesMinutesToCutOpen) {
  const InputShape ordinary = shape("ordinary", testing::torus_soup(16, 10)),
                   large = shape("large", testing::torus_soup(400, 260));
  EXPECT_THAT(rank_references({large, ordinary, large}), ::testing::ElementsAre(1, 0, 2));
}

}  // namespace
}  // namespace foramen
