#include <gtest/gtest.h>

#include <Eigen/LU>

#include <Eigen/Cholesky>

#include <limits>
#include <vector>

#include "parameterize/block_cholesky.hpp"
#include "parameterize/distortion.hpp"
#include "parameterize/flip_free_step.hpp"
#include "parameterize/mapped_torus.hpp"
#include "parameterize/newton_system.hpp"
#include "parameterize/optimise_map.hpp"

namespace foramen {
namespace {

Eigen::MatrixXd torus_coordinates(const testing::MappedTorus& torus) {
  Eigen::MatrixXd c(torus.mesh.vertex_count(), 2);
  for (VertexId v : torus.mesh.vertices()) c.row(v.index) = torus.map.turns[v].transpose();
  return c;
}

Eigen::MatrixXd dense(const Mesh& mesh, const BlockMatrix& m) {
  Eigen::MatrixXd d = Eigen::MatrixXd::Zero(2 * mesh.vertex_count(), 2 * mesh.vertex_count());
  for (VertexId v : mesh.vertices()) d.block<2, 2>(2 * v.index, 2 * v.index) = m.diagonal[v];
  for (EdgeId e : mesh.edges()) {
    const int from = mesh.from(mesh.halfedge(e)).index, to = mesh.to(mesh.halfedge(e)).index;
    d.block<2, 2>(2 * from, 2 * to) = m.coupling[e];
    d.block<2, 2>(2 * to, 2 * from) = m.coupling[e].transpose();
  }
  return d;
}

BlockMatrix random_definite(const Mesh& mesh, Rng& rng) {
  BlockMatrix m(mesh);
  const auto random = [&] { return Mat2{{rng.normal(), rng.normal()}, {rng.normal(), rng.normal()}}; };
  for (EdgeId e : mesh.edges()) m.coupling[e] = random();
  for (VertexId v : mesh.vertices()) {
    const Mat2 a = random();
    m.diagonal[v] = a * a.transpose() + 30 * Mat2::Identity();
  }
  return m;
}

TEST(Dissection, HoldsEveryVertexOnceAndSeparates) {
  for (const auto& [name, torus] : testing::genus1_maps()) {
    SCOPED_TRACE(name);
    const DissectionTree tree = dissect(torus.mesh, torus_coordinates(torus));
    std::vector<int> node(torus.mesh.vertex_count(), -1), parent(tree.size(), -1);
    for (std::size_t k = 0; k < tree.size(); ++k) {
      for (int v : tree[k].columns) {
        EXPECT_EQ(node[v], -1);
        node[v] = static_cast<int>(k);
      }
      for (int c : tree[k].children)
        if (c >= 0) {
          EXPECT_LT(c, static_cast<int>(k));
          parent[c] = static_cast<int>(k);
        }
    }
    const auto is_above = [&](int upper, int lower) {
      for (; lower >= 0; lower = parent[lower])
        if (lower == upper) return true;
      return false;
    };
    for (EdgeId e : torus.mesh.edges()) {
      const HalfedgeId h = torus.mesh.halfedge(e);
      const int a = node[torus.mesh.from(h).index], b = node[torus.mesh.to(h).index];
      EXPECT_TRUE(is_above(a, b) || is_above(b, a));
    }
  }
}

TEST(BlockCholesky, SolvesLikeADenseFactorisation) {
  Rng rng(1);
  for (const auto& [name, torus] : testing::genus1_maps()) {
    SCOPED_TRACE(name);
    BlockCholesky cholesky(torus.mesh, torus_coordinates(torus));
    for (int again = 0; again < 2; ++again) {  // the second time, the same memory is used
      const BlockMatrix m = random_definite(torus.mesh, rng);
      const Eigen::MatrixXd rhs =
          Eigen::MatrixXd::NullaryExpr(2 * torus.mesh.vertex_count(), 3, [&] { return rng.normal(); });
      ASSERT_TRUE(cholesky.factor(m));
      Eigen::MatrixXd x = rhs;
      cholesky.solve(x);
      const Eigen::MatrixXd expected = dense(torus.mesh, m).llt().solve(rhs);
      EXPECT_NEAR((x - expected).norm() / expected.norm(), 0, 1e-11);
    }
  }
}

TEST(BlockCholesky, RefusesAnIndefiniteMatrixAndRecovers) {
  const auto torus = testing::mapped_bumpy_torus(12, 9, 1);
  Rng rng(2);
  BlockMatrix m = random_definite(torus.mesh, rng);
  BlockCholesky cholesky(torus.mesh, torus_coordinates(torus));
  m.diagonal[VertexId(50)] -= 200 * Mat2::Identity();
  EXPECT_FALSE(cholesky.factor(m));
  m.diagonal[VertexId(50)] += 200 * Mat2::Identity();
  EXPECT_TRUE(cholesky.factor(m));
}

TEST(FlipFreeStep, IsTheFirstPlaceWithoutArea) {
  Rng rng(3);
  int bounded = 0;
  for (int k = 0; k < 2000; ++k) {
    Vec4 q(rng.normal(), rng.normal(), rng.normal(), rng.normal());
    const Vec4 d = k % 5 == 0 ? Vec4(0, 0, rng.normal(), rng.normal())
                              : Vec4(rng.normal(), rng.normal(), rng.normal(), rng.normal());
    if (doubled_area(q) < 0) q.head<2>().swap(q.tail<2>());
    const double s = first_collapse(q, d);
    ASSERT_GT(s, 0);
    const double until = std::isfinite(s) ? s : 100;
    for (int i = 0; i < 100; ++i) EXPECT_GT(doubled_area(q + (i / 100.0) * until * d), 0);
    if (!std::isfinite(s)) continue;
    ++bounded;
    EXPECT_NEAR(doubled_area(q + s * d) / (q.squaredNorm() + s * s * d.squaredNorm()), 0, 1e-12);
  }
  EXPECT_GT(bounded, 500);
}

// Gradient and Hessian of the whole energy, jumps and lattice included, by central differences.
TEST(NewtonSystem, AgreesWithCentralDifferences) {
  auto torus = testing::mapped_bumpy_torus(6, 5, 4);
  torus.map.lattice << 1.3, 0.2, 0, 1 / 1.3;
  OptimiseMapOptions options;
  options.free_lattice = true;
  const MapEnergy energy(torus.mesh, torus.map, options, nullptr);
  const MapState here = energy.state(torus.map);
  const LatticeShape shape(here.lattice);
  EXPECT_NEAR((shape.lattice() - here.lattice).norm(), 0, 1e-14);
  NewtonSystem system(energy, true);
  system.assemble(here, 1.0);
  EXPECT_NEAR(system.value, energy.value(here), 1e-12);

  const int unknowns = 2 * torus.mesh.vertex_count();
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(unknowns + 2, unknowns + 2);
  hessian.topLeftCorner(unknowns, unknowns) = dense(torus.mesh, system.hessian);
  hessian.topRightCorner(unknowns, 2) = system.lattice_coupling;
  hessian.bottomRightCorner(2, 2) = system.lattice_hessian;
  const double h = 1e-6;
  const auto moved = [&](int k, double by) {
    MapState s = here;
    if (k < unknowns)
      s.x(k % 2, k / 2) += by;
    else
      s.lattice = shape.moved(by * Vec2::Unit(k - unknowns)).lattice();
    return s;
  };
  NewtonSystem ahead(energy, true), behind(energy, true);
  for (int k = 2; k < unknowns + 2; ++k) {  // the first vertex is fixed
    const MapState plus = moved(k, h), minus = moved(k, -h);
    const double slope = (energy.value(plus) - energy.value(minus)) / (2 * h);
    const double analytic = k < unknowns ? system.gradient[k] : system.lattice_gradient[k - unknowns];
    EXPECT_NEAR(slope, analytic, 1e-5 * (1 + std::abs(analytic)));
    ahead.assemble(plus, 1.0);
    behind.assemble(minus, 1.0);
    const Eigen::VectorXd column = (ahead.gradient - behind.gradient) / (2 * h);
    EXPECT_NEAR((column - hessian.col(k).head(unknowns)).norm(), 0, 1e-5 * (1 + column.norm()));
    if (k < unknowns) continue;
    const Vec2 in_lattice = (ahead.lattice_gradient - behind.lattice_gradient) / (2 * h);
    EXPECT_NEAR((in_lattice - system.lattice_hessian.col(k - unknowns)).norm(), 0,
                1e-4 * (1 + in_lattice.norm()));
  }
}

}  // namespace
}  // namespace foramen
