#include "foramen/stages/build_model.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "support/torus_family.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAre;
using testing::family;
using testing::small;

void expect_on(const Mesh& surface, const std::vector<Vec3>& landmarks) {
  const TriangleTree tree(surface);
  for (const Vec3& p : landmarks) EXPECT_LT(tree.closest(p).squared_distance, 1e-12);
}

TEST(BuildModel, LandmarksLieOnEveryInputAndNoTriangleIsFlipped) {
  const std::vector<Shape> shapes = family();
  const BuiltModel built = build_model(shapes, small(), RunContext(2));
  EXPECT_THAT(built.landmarks.names, ElementsAre("s0", "s1", "s2", "s3"));
  EXPECT_EQ(built.landmarks.remaining_flips, 0);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE(shapes[i].name);
    EXPECT_EQ(built.registration.shapes[i].name, shapes[i].name);
    EXPECT_TRUE(built.registration.shapes[i].certificate.valid());
    const std::vector<Vec3>& landmarks = built.landmarks.points[i];
    ASSERT_EQ(landmarks.size(), built.landmarks.mesh.turns.size());
    expect_on(shapes[i].mesh, landmarks);
    const Mesh corresponding = build_mesh({landmarks, built.landmarks.mesh.triangles});
    EXPECT_EQ(corresponding.euler_characteristic(), 0);
    // Landmarks lie on the surface, so the triangles cut off about h^2 / (6 r^2) = 2 % of the volume of a
    // tube of radius r.
    EXPECT_NEAR(signed_volume(corresponding) / signed_volume(shapes[i].mesh), 1, 0.05);
  }
  EXPECT_GT(built.registration.frame.reference.shape_map.map.jumps.size(), 0);
  const Eigen::VectorXd& variance = built.aligned.model.variance();
  EXPECT_GT(variance[0], 0.6 * variance.sum()) << "one bump varies";
}

TEST(BuildModel, TheBaselineTakesTheSameReferenceAndNumberOfLandmarks) {
  const std::vector<Shape> shapes = family();
  BuildOptions options = small();
  options.correspondence.method = Method::icp;
  const BuiltModel built = build_model(shapes, options, RunContext(2));
  EXPECT_EQ(built.landmarks.mesh.turns.size(), 1200u);
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const bool is_reference = static_cast<int>(i) == built.registration.reference;
    EXPECT_EQ(built.registration.shapes[i].mapped, is_reference);
    expect_on(shapes[i].mesh, built.landmarks.points[i]);
  }
}

}  // namespace
}  // namespace foramen
