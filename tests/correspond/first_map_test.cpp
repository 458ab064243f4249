#include "correspond/first_map.hpp"

#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "correspond/propagate_loops.hpp"
#include "correspond/transfer_homology.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/parameterize/torus_map.hpp"
#include "support/lopsided_torus.hpp"
#include "topology/linking.hpp"

namespace foramen {
namespace {

using testing::lopsided_torus_soup;
using testing::renumbered;

class FirstMapTest : public ::testing::Test {
 protected:
  const ReferenceLoops reference =
      find_reference_loops(build_mesh(lopsided_torus_soup(30, 16)), RunContext(1));
  const TorusMap reference_map =
      first_map(reference.mesh, reference.mesh, reference, InitialMap::torus, EdgeCost::length_weighted).map;
  FirstMap of(const Mesh& shape, InitialMap initial = InitialMap::torus) const {
    return first_map(shape, shape, reference, initial, EdgeCost::length_weighted);
  }
};

TEST_F(FirstMapTest, OfTheReferenceItselfHasItsLoopsAsPeriods) {
  const FirstMap own = of(reference.mesh);
  EXPECT_TRUE(seifert_test(own.homology, own.seifert, reference.seifert));
  EXPECT_EQ(own.map.lattice, Lattice::Identity());
  for (int k = 0; k < 2; ++k) {
    Vec2i around = Vec2i::Zero();
    for (HalfedgeId h : reference.loops.loops[k]) around += own.map.jumps[h];
    EXPECT_EQ(around, Vec2i(k == 0 ? 1 : 0, k == 0 ? 0 : 1));
  }
}

TEST_F(FirstMapTest, OfAnyTriangulationIsOneToOneAndRunsWithTheReferences) {
  for (std::uint64_t seed = 0; seed < 3; ++seed)
    for (const InitialMap initial : {InitialMap::torus, InitialMap::rectangle}) {
      SCOPED_TRACE(seed);
      const Mesh shape = build_mesh(renumbered(lopsided_torus_soup(26, 18, 0.8), seed));
      const FirstMap first = of(shape, initial);
      EXPECT_TRUE(seifert_test(first.homology, first.seifert, reference.seifert));
      EXPECT_TRUE(certify(shape, first.map).valid());
      EXPECT_GT(map_agreement(shape, first.map, reference.mesh, reference_map).minCoeff(), 0);
    }
}

// The shape is compared in its aligned position, while linking numbers are computed in its original position.
// Here this is the mirror image, whose linking numbers have the other sign.
TEST_F(FirstMapTest, LoopsOfAnotherClassAreRefused) {
  const Mesh& shape = reference.mesh;
  std::vector<Vec3> mirrored(shape.positions().begin(), shape.positions().end());
  for (Vec3& p : mirrored) p.z() = -p.z();
  try {
    first_map(shape, shape.with_positions(mirrored), reference, InitialMap::torus, EdgeCost::length_weighted);
    FAIL() << "the Seifert matrices " << reference.seifert << " should differ";
  } catch (const TopologyError& e) {
    EXPECT_THAT(e.what(), ::testing::HasSubstr("Seifert"));
  }
}

TEST_F(FirstMapTest, TranslationBringsAMovedMapBack) {
  const Mesh& mesh = reference.mesh;
  for (const Vec2& by : {Vec2(0.2, -0.3), Vec2(0.49, 0.48), Vec2(-1.1, 5.25), Vec2(0, 0)}) {
    TorusMap moved = reference_map;
    for (Vec2& p : moved.turns) p += by;
    const TorusMap back = translated_onto(moved, mesh, mesh, reference_map);
    EXPECT_EQ(back.jumps, reference_map.jumps);
    const Vec2 whole = (back.turns[VertexId(0)] - reference_map.turns[VertexId(0)]).array().round().matrix();
    for (VertexId v : mesh.vertices())
      EXPECT_LT((back.turns[v] - reference_map.turns[v] - whole).norm(), 1e-12);
  }
}

TEST_F(FirstMapTest, TranslationIsTheMeanOverTheAreaNotTheVertices) {
  const Mesh& mesh = reference.mesh;
  constexpr int tube = 16;
  TorusMap moved = reference_map;
  const auto areas = vertex_areas(mesh);
  double area = 0, total = 0;
  for (VertexId v : mesh.vertices()) {
    total += areas[v];
    if (std::abs(v.index % tube - tube / 2) <= tube / 4) continue;  // the inside of the tube
    moved.turns[v].x() += 0.02;
    area += areas[v];
  }
  ASSERT_GT(area / total, 0.5);
  // Fewer than half of the vertices are moved, but more than half of the area. An unweighted mean would fail.
  const TorusMap back = translated_onto(moved, mesh, mesh, reference_map);
  // The circular and the arithmetic mean differ only in third order of the spread.
  EXPECT_NEAR(back.turns[VertexId(0)].x() - moved.turns[VertexId(0)].x(), -0.02 * area / total, 1e-4);
}

}  // namespace
}  // namespace foramen
