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
    ASSERT_EQ(outcome.landmarks.size(), build.landmarks.turns.size());
    const TriangleTree tree(outcome.input.mesh);
    for (const Vec3& p : outcome.landmarks) EXPECT_LT(tree.closest(p).squared_distance, 1e-12);
    const Mesh corresponding = build_mesh({outcome.landmarks, build.landmarks.triangles});
    EXPECT_EQ(corresponding.euler_characteristic(), 0);
    // Landmarks lie on the surface, so the chords cut off about h^2 / (6 r^2) = 2 % of a tube of radius r.
    EXPECT_NEAR(signed_volume(corresponding) / signed_volume(outcome.input.mesh), 1, 0.05);
  }
  EXPECT_GT(build.model.variance()[0], 0.6 * build.model.variance().sum()) << "one bump varies";
}

TEST(BuildModel, TheBaselineTakesTheSameReferenceAndNumberOfLandmarks) {
  BuildOptions options = small();
  options.method = Method::icp;
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
  options.reference = "nobody";
  EXPECT_THROW(build_model(family(), options, RunContext(1)), InvalidInput);
}

TEST(ChooseReference, TakesTheShapeOfMedianSize) {
  std::vector<InputShape> shapes;
  for (double size : {1.3, 0.8, 1.0, 1.1, 0.5}) {
    TriangleSoup soup = testing::torus_soup(16, 10);
    for (Vec3& p : soup.points) p *= size;
    shapes.push_back(shape("x", soup));
  }
  EXPECT_EQ(choose_reference(shapes), 2);
}

}  // namespace
}  // namespace foramen
