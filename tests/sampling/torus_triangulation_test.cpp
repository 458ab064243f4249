#include "sampling/torus_triangulation.hpp"

#include <gtest/gtest.h>

#include "sampling/mapped_tori.hpp"

namespace foramen::detail {
namespace {

TEST(KeepsArea, AllowsAMillionthAndNoLess) {
  EXPECT_TRUE(TorusTriangulation::keeps_area(5, 5'000'000));
  EXPECT_FALSE(TorusTriangulation::keeps_area(5, 5'000'001));
  EXPECT_FALSE(TorusTriangulation::keeps_area(0, 0));
  EXPECT_FALSE(TorusTriangulation::keeps_area(-1, 0));
}

// The corner b of the quad a d b c is moved to the line from d to c, so that the flipped edge cuts off a
// sliver.
TEST(TorusTriangulation, AnEdgeIsNotFlippedIfATriangleNearlyVanishes) {
  const auto torus = testing::torus(400);
  TorusTriangulation mesh(torus.mesh, torus.map);
  int h = 0;
  while (h < mesh.halfedge_slots() && !mesh.can_flip(h)) ++h;
  ASSERT_LT(h, mesh.halfedge_slots());
  const int b = mesh.to(h);
  const Fixed2 before = mesh.place(b);
  const Fixed2 to_c = mesh.along(TorusTriangulation::next(h)),
               to_d = -mesh.along(TorusTriangulation::prev(mesh.twin(h)));
  const Fixed2 onto_line{(to_c.x + to_d.x) / 2, (to_c.y + to_d.y) / 2};
  const auto moved_by = [&](double share) {
    const Fixed2 step{static_cast<std::int64_t>(share * static_cast<double>(onto_line.x)),
                      static_cast<std::int64_t>(share * static_cast<double>(onto_line.y))};
    mesh.set_place(b, before + step);
    return mesh.can_flip(h);
  };
  EXPECT_TRUE(moved_by(0.9));
  EXPECT_FALSE(moved_by(1 - 1e-8)) << "positive, but a sliver";
}

}  // namespace
}  // namespace foramen::detail
