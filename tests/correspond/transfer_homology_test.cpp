#include "correspond/transfer_homology.hpp"

#include <gtest/gtest.h>

#include "correspond/propagate_loops.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "parameterize/initial_map.hpp"
#include "support/meshes.hpp"
#include "topology/linking.hpp"
#include "topology/periods.hpp"

namespace foramen {
namespace {

using testing::bumpy_torus_soup;
using testing::renumbered;

Eigen::Matrix2i matrix(int a, int b, int c, int d) {
  Eigen::Matrix2i m;
  m << a, b, c, d;
  return m;
}

// A reference and a shape: the same kind of torus with another triangulation, other bumps and its own loops.
struct Pair {
  ReferenceLoops reference;
  TorusMap reference_map;
  Mesh shape;
  LoopSystem loops;
  Cocycle form;
  HomologyTransfer transfer;
};

Pair make_pair_of_tori(std::uint64_t seed) {
  Pair pair;
  pair.reference = find_reference_loops(build_mesh(bumpy_torus_soup(24, 14, 5)), RunContext(1));
  pair.reference_map =
      harmonic_torus_map(pair.reference.mesh, cocycle(pair.reference.mesh, pair.reference.loops));
  pair.shape = build_mesh(renumbered(bumpy_torus_soup(22, 13, 6), seed));
  pair.loops = oriented(pair.shape, greedy_loops(pair.shape, VertexId(0), edge_lengths(pair.shape)));
  pair.form = cocycle(pair.shape, pair.loops);
  pair.transfer = transfer_homology(pair.shape, pair.form, pair.reference);
  return pair;
}

TEST(TransferHomology, OntoItselfIsTheIdentity) {
  const ReferenceLoops reference =
      find_reference_loops(build_mesh(bumpy_torus_soup(20, 12, 7)), RunContext(1));
  const auto transfer =
      transfer_homology(reference.mesh, cocycle(reference.mesh, reference.loops), reference);
  EXPECT_EQ(transfer.a, Eigen::Matrix2i::Identity());
}

TEST(TransferHomology, RenamedPeriodsAreTheReferences) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const Pair pair = make_pair_of_tori(seed);
    const Eigen::Matrix2i inverse = inverse_unimodular(pair.transfer.a);
    EXPECT_EQ(inverse * pair.transfer.a, Eigen::Matrix2i::Identity());
    for (int k = 0; k < 2; ++k) {
      const Vec2i period = inverse * integrate(pair.form, pair.transfer.transferred[k]);
      EXPECT_EQ(period, Vec2i(k == 0 ? 1 : 0, k == 0 ? 0 : 1));
    }
  }
}

TEST(TransferHomology, ATwistASwapAndASignChangeAreEachRefused) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const Pair pair = make_pair_of_tori(seed);
    const Eigen::Matrix2i shape = seifert_matrix(pair.shape, pair.loops.loops[0], pair.loops.loops[1]);
    const Eigen::Matrix2i& a = pair.transfer.a;
    const auto passes = [&](const Eigen::Matrix2i& planted) {
      return seifert_test(a * planted, shape, pair.reference.seifert);
    };
    EXPECT_TRUE(passes(Eigen::Matrix2i::Identity()));
    EXPECT_FALSE(passes(matrix(1, 1, 0, 1))) << "Dehn twist";
    EXPECT_FALSE(passes(matrix(1, 0, -2, 1))) << "Dehn twist along the other loop";
    EXPECT_FALSE(passes(matrix(0, 1, 1, 0))) << "swap";
    EXPECT_FALSE(passes(matrix(0, -1, 1, 0))) << "swap that keeps the orientation";
    EXPECT_FALSE(passes(matrix(-1, 0, 0, 1))) << "one sign";
    EXPECT_TRUE(passes(matrix(-1, 0, 0, -1))) << "both signs: left to map_agreement";
  }
}

TEST(TransferHomology, BothSignsChangedMakeTheMapsDisagree) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const Pair pair = make_pair_of_tori(seed);
    const TorusMap unnamed = harmonic_torus_map(pair.shape, pair.form);
    const auto agreement_with = [&](const Eigen::Matrix2i& a) {
      return map_agreement(pair.shape, change_basis(unnamed, inverse_unimodular(a)), pair.reference.mesh,
                           pair.reference_map);
    };
    EXPECT_GT(agreement_with(pair.transfer.a).minCoeff(), 0.5);
    EXPECT_LT(agreement_with(-pair.transfer.a).maxCoeff(), -0.5);
  }
}

// A finished map of the right class passes. A twist, an exchange or a reversal of the loops is refused,
// although none of them flips a triangle.
TEST(TransferHomology, AFinishedMapOfAnotherClassIsRefused) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    SCOPED_TRACE(seed);
    const Pair pair = make_pair_of_tori(seed);
    const TorusMap right =
        change_basis(harmonic_torus_map(pair.shape, pair.form), inverse_unimodular(pair.transfer.a));
    const auto check = [&](const TorusMap& map) {
      require_reference_homology(pair.shape, map, Vec2(0.3, 0.8), pair.reference.seifert);
    };
    EXPECT_NO_THROW(check(right));
    EXPECT_THROW(check(change_basis(right, matrix(1, 1, 0, 1))), TopologyError) << "Dehn twist";
    EXPECT_THROW(check(change_basis(right, matrix(1, 0, -2, 1))), TopologyError) << "the other Dehn twist";
    EXPECT_THROW(check(change_basis(right, matrix(0, -1, 1, 0))), TopologyError) << "swap";
    EXPECT_THROW(check(change_basis(right, matrix(-1, 0, 0, 1))), TopologyError) << "one sign";
    EXPECT_NO_THROW(check(change_basis(right, matrix(-1, 0, 0, -1)))) << "both signs: left to map_agreement";
  }
}

TEST(TransferHomology, AMirroredShapeIsRefused) {
  const Pair pair = make_pair_of_tori(1);
  const TorusMap right =
      change_basis(harmonic_torus_map(pair.shape, pair.form), inverse_unimodular(pair.transfer.a));
  std::vector<Vec3> mirrored;
  for (const Vec3& p : pair.shape.positions()) mirrored.emplace_back(p.x(), p.y(), -p.z());
  EXPECT_THROW(require_reference_homology(pair.shape.with_positions(mirrored), right, Vec2::Zero(),
                                          pair.reference.seifert),
               Error);
}

}  // namespace
}  // namespace foramen
