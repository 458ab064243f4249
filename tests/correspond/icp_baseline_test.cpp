#include "correspond/icp_baseline.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

// Two horizontal walls of a thin plate, 0.4 mm apart, one triangle pair each: normals away from each other.
Mesh thin_plate() {
  TriangleSoup soup;
  for (double z : {0.2, -0.2})
    for (int corner = 0; corner < 4; ++corner)
      soup.points.emplace_back(corner % 2 == 0 ? -10 : 10, corner < 2 ? -10 : 10, z);
  soup.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 7, 5}, {4, 6, 7}};
  return build_mesh(std::move(soup));
}

const Vec3 up = Vec3::UnitZ(), down = -Vec3::UnitZ();

IcpCorrespondence of_one(const Vec3& landmark, const Vec3& normal, const Mesh& shape,
                         const IcpCorrespondenceOptions& options = {}) {
  return icp_correspondence(std::array{landmark}, std::array{normal}, TriangleTree(shape),
                            RigidTransform::Identity(), options);
}

TEST(IcpCorrespondence, TakesTheWallThatFacesTheSameWay) {
  const Mesh plate = thin_plate();
  const Vec3 landmark(1, 2, -0.15);  // nearer to the lower wall
  const auto above = of_one(landmark, up, plate), below = of_one(landmark, down, plate);
  EXPECT_LT((above.points[0] - Vec3(1, 2, 0.2)).norm(), 1e-12);
  EXPECT_LT((below.points[0] - Vec3(1, 2, -0.2)).norm(), 1e-12);
  EXPECT_EQ(above.without_compatible + below.without_compatible, 0);
  EXPECT_LT((position(plate, above.on[0]) - above.points[0]).norm(), 1e-12);
}

TEST(IcpCorrespondence, WithoutACompatiblePointThePlainClosestIsTakenAndCounted) {
  const Mesh plate = thin_plate();
  const Vec3 sideways = Vec3::UnitX();
  const auto found = of_one(Vec3(1, 2, -0.15), sideways, plate);
  EXPECT_EQ(found.without_compatible, 1);
  EXPECT_LT((found.points[0] - Vec3(1, 2, -0.2)).norm(), 1e-12);
}

TEST(IcpCorrespondence, TheCapLimitsTheSearchForCompatiblePoints) {
  const Mesh plate = thin_plate();
  const Vec3 landmark(1, 2, -0.15);  // 0.35 mm from the upper wall
  EXPECT_EQ(of_one(landmark, up, plate, {.search_cap = 0.36}).without_compatible, 0);
  EXPECT_EQ(of_one(landmark, up, plate, {.search_cap = 0.34}).without_compatible, 1);
}

TEST(IcpCorrespondence, TheCosineMustBeExceeded) {
  const Mesh plate = thin_plate();
  const Vec3 tilted(0.6, 0, 0.8);
  EXPECT_EQ(of_one(Vec3::Zero(), tilted, plate, {.min_normal_cosine = 0.79}).without_compatible, 0);
  EXPECT_EQ(of_one(Vec3::Zero(), tilted, plate, {.min_normal_cosine = 0.81}).without_compatible, 1);
}

TEST(IcpCorrespondence, LandmarksOfTheShapeItselfStayAndComeBackInItsOwnCoordinates) {
  const Mesh shape = build_mesh(testing::bumpy_torus_soup(30, 16, 3));
  const RigidTransform to_reference =
      Eigen::Translation3d(40, -7, 90) * Eigen::AngleAxisd(1.3, Vec3(2, -1, 1).normalized());
  std::vector<Vec3> landmarks, normals;
  for (const FaceId f : shape.faces()) {
    const auto t = shape.triangle(f);
    landmarks.push_back(to_reference * ((t[0] + t[1] + t[2]) / 3));
    normals.push_back(to_reference.linear() * unit_normal(t));
  }
  const auto found = icp_correspondence(landmarks, normals, TriangleTree(shape), to_reference);
  EXPECT_EQ(found.without_compatible, 0);
  ASSERT_EQ(found.points.size(), landmarks.size());
  for (std::size_t i = 0; i < landmarks.size(); ++i)
    EXPECT_LT((to_reference * found.points[i] - landmarks[i]).norm(), 1e-9);
}

TEST(IcpCorrespondence, RefusesWhatItCannotUse) {
  const TriangleTree plate(thin_plate());
  const std::vector<Vec3> two(2, Vec3::Zero()), one(1, up);
  const RigidTransform same = RigidTransform::Identity();
  EXPECT_THROW(icp_correspondence(two, one, plate, same), InvalidInput);
  EXPECT_THROW(icp_correspondence(one, one, TriangleTree(Mesh()), same), InvalidInput);
  EXPECT_THROW(icp_correspondence(one, one, plate, same, {.min_normal_cosine = 1}), InvalidInput);
  EXPECT_THROW(icp_correspondence(one, one, plate, same, {.search_cap = 0}), InvalidInput);
}

}  // namespace
}  // namespace foramen
