#include "foramen/model/build_shape_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

// A torus whose height is scaled by a factor, and which is then moved as a whole.
std::vector<Vec3> member(double factor, double angle) {
  const Mat3 rotation = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Vec3> points = testing::torus_soup(12, 8).points;
  for (Vec3& p : points) p = rotation * Vec3(p.x(), p.y(), factor * p.z()) + Vec3(10 * angle, 5, -3);
  return points;
}

const std::vector<std::array<int, 3>> triangles = testing::torus_soup(12, 8).triangles;

TEST(BuildShapeModel, PosesDoNotMatterAndOneWayOfVaryingIsOneMode) {
  const AlignedModel built =
      build_shape_model({member(0.8, 0), member(1, 1), member(1.2, 2), member(1.4, -1)}, triangles);
  const Eigen::VectorXd& variance = built.model.variance();
  EXPECT_GT(variance[0], 1);
  EXPECT_LT(variance.tail(variance.size() - 1).sum(), 1e-9 * variance[0]);
  EXPECT_EQ(built.alignment.transforms.size(), 4u);
}

TEST(BuildShapeModel, CopiesOfOneShapeHaveNoVariation) {
  EXPECT_THROW(build_shape_model({member(1, 0), member(1, 1), member(1, 2)}, triangles), InvalidInput);
}

TEST(BuildShapeModel, WeightsByAreaHaveMeanOne) {
  const AlignedModel built = build_shape_model({member(0.8, 0), member(1, 1), member(1.2, 2)}, triangles,
                                               {.weights = LandmarkWeights::area});
  EXPECT_NEAR(built.model.total_weight(), built.model.landmarks(), 1e-9);
  EXPECT_TRUE(
      build_shape_model({member(0.8, 0), member(1, 1), member(1.2, 2)}, triangles).model.weights().empty());
}

}  // namespace
}  // namespace foramen
