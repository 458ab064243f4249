#include "correspond/own_loops.hpp"

#include <gtest/gtest.h>

#include "correspond/knobbly_family.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

// A template whose map is expressed in another basis than that of its shortest loops.
TemplateSurface skewed_template() {
  const testing::MappedSurface member = testing::member_surface(1, 1500);
  Eigen::Matrix2i skew;
  skew << 1, 2, 0, 1;
  return {member.mesh, change_basis(member.map, skew)};
}

TEST(OwnLoops, AreTheBasisOfTheTemplatesMap) {
  const OwnLoops own = with_own_loops(skewed_template(), RunContext(1));
  const Cocycle form{own.reference.shape_map.map.jumps};
  EXPECT_EQ(integrate(form, own.reference.loops.loops.loops[0]), Vec2i(1, 0));
  EXPECT_EQ(integrate(form, own.reference.loops.loops.loops[1]), Vec2i(0, 1));
  EXPECT_TRUE(certify(own.reference.mesh(), own.reference.shape_map.map).valid());
}

TEST(InBasisOf, GivesTheMapOfTheTemplateBack) {
  const TemplateSurface surface = skewed_template();
  const OwnLoops own = with_own_loops(surface, RunContext(1));
  const TorusMap back = in_basis_of(own.reference.shape_map.map, own, surface.map);
  EXPECT_EQ(back.jumps, surface.map.jumps);
  EXPECT_EQ(back.lattice, surface.map.lattice);
  for (VertexId v : surface.mesh.vertices()) EXPECT_LT((back.turns[v] - surface.map.turns[v]).norm(), 1e-12);
}

}  // namespace
}  // namespace foramen
