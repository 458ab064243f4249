#include "correspond/register_shape.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "support/lopsided_torus.hpp"

namespace foramen {
namespace {

using testing::lopsided_torus_soup;
using testing::renumbered;

RigidTransform some_pose() {
  RigidTransform pose = RigidTransform::Identity();
  pose.rotate(Eigen::AngleAxisd(2.2, Vec3(1, -2, 0.5).normalized())).pretranslate(Vec3(80, -30, 200));
  return pose;
}

double largest_difference_in_turns(const TorusMap& a, const std::vector<int>& to_b, const TorusMap& b) {
  double largest = 0;
  for (VertexId v : a.turns.ids()) {
    const Vec2 d = a.turns[v] - b.turns[VertexId(to_b[v.index])];
    largest = std::max(largest, (d - d.array().round().matrix()).norm());
  }
  return largest;
}

TEST(RegisterShape, AMovedCopyOfTheReferenceGetsTheReferencesCoordinates) {
  const Mesh mesh = build_mesh(lopsided_torus_soup(40, 24));
  const RunContext ctx(1);
  const Reference reference = map_reference(mesh, ctx);
  EXPECT_TRUE(reference.shape_map.certificate.valid());
  EXPECT_EQ(reference.shape_map.certificate.flipped, 0);
  EXPECT_NEAR(reference.shape_map.map.lattice.determinant(), 1, 1e-9);
  const RegisteredShape copy = register_shape(transformed(mesh, some_pose()), reference, ctx);
  EXPECT_TRUE(copy.shape_map.certificate.valid());
  EXPECT_GT(copy.agreement.minCoeff(), 0.9);
  std::vector<int> same(mesh.vertex_count());
  for (std::size_t v = 0; v < same.size(); ++v) same[v] = static_cast<int>(v);
  EXPECT_LT(largest_difference_in_turns(copy.shape_map.map, same, reference.shape_map.map), 0.02);
}

TEST(RegisterShape, ThePapersWayMapsWithoutFlips) {
  const RunContext ctx(1);
  const RegisterOptions options = paper_options();
  const Reference reference = map_reference(build_mesh(lopsided_torus_soup(20, 12)), ctx, options);
  const RegisteredShape shape =
      register_shape(transformed(build_mesh(renumbered(lopsided_torus_soup(22, 13), 1)), some_pose()),
                     reference, ctx, options);
  EXPECT_EQ(shape.shape_map.certificate.flipped, 0);
  EXPECT_LE(shape.shape_map.final_energy, shape.shape_map.initial_energy);
}

}  // namespace
}  // namespace foramen
