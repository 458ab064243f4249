#include "match/deform_template.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "match/smooth_displacements.hpp"
#include "support/lopsided_torus.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

using testing::knobbly_torus_soup;
using testing::SmoothDisplacement;

double rms(const std::vector<Vec3>& a, std::span<const Vec3> b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

class DeformTemplate : public ::testing::Test {
 protected:
  const Mesh surface = build_mesh(knobbly_torus_soup(70, 40));
  const Eigen::MatrixXd functions = smooth_displacements(surface.positions());
  const RunContext ctx{1};
  const SmoothDisplacement truth{0.8, 90, Rng(3)};

  static Mesh displaced(const Mesh& mesh, const SmoothDisplacement& by) {
    std::vector<Vec3> positions;
    for (const Vec3& p : mesh.positions()) positions.push_back(by(p));
    return mesh.with_positions(std::move(positions));
  }
};

TEST_F(DeformTemplate, StaysOnItself) {
  EXPECT_LT(rms(deform_template(surface, functions, surface, ctx), surface.positions()), 0.05);
}

TEST_F(DeformTemplate, RecoversASmoothDisplacementAlsoAlongTheSurface) {
  const Mesh goal = displaced(surface, truth);
  // The displaced surface in another triangulation, which has no vertex of the template.
  const Mesh shape = displaced(build_mesh(knobbly_torus_soup(83, 47)), truth);
  const auto bent = deform_template(surface, functions, shape, ctx);
  const TriangleTree tree(shape);
  std::vector<Vec3> closest;
  for (const Vec3& p : surface.positions()) closest.push_back(tree.closest(p).point);
  EXPECT_GT(rms(closest, goal.positions()), 0.8);
  EXPECT_LT(rms(bent, goal.positions()), 0.25 * rms(closest, goal.positions()));
}

TEST_F(DeformTemplate, MovesWithTheTwoSurfaces) {
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(1.1, Vec3(2, -1, 1).normalized())).pretranslate(Vec3(30, 40, -90));
  const Mesh shape = displaced(surface, truth), moved = transformed(surface, motion);
  const auto here = deform_template(surface, functions, shape, ctx);
  const auto there =
      deform_template(moved, smooth_displacements(moved.positions()), transformed(shape, motion), ctx);
  EXPECT_LT(rms(transformed(here, motion), there), 0.02);
}

TEST_F(DeformTemplate, ContinuesFromAStart) {
  const Mesh shape = displaced(surface, truth);
  const auto bent = deform_template(surface, functions, shape, ctx, {.noise_mm = {0.25}, .iterations = 1},
                                    shape.positions());
  EXPECT_LT(rms(bent, shape.positions()), 0.15);
}

TEST_F(DeformTemplate, APriorThatKnowsTheDirectionLowersTheError) {
  const Mesh goal = displaced(surface, truth);
  const Mesh shape = displaced(build_mesh(knobbly_torus_soup(83, 47)), truth);
  // The direction that the prior knows is half the true displacement.
  Eigen::MatrixX3d displacement(surface.vertex_count(), 3);
  for (VertexId v : surface.vertices())
    displacement.row(v.index) = 0.5 * (goal.position(v) - surface.position(v)).transpose();
  const Eigen::MatrixX3d coefficients = functions.colPivHouseholderQr().solve(displacement);
  const DisplacementPrior prior{.variance = 0.01, .directions = coefficients.reshaped()};
  const auto error = [&](const DisplacementPrior& known) {
    return rms(deform_template(surface, functions, shape, ctx, {}, {}, known), goal.positions());
  };
  EXPECT_LT(error(prior), 0.5 * error({}));
}

TEST_F(DeformTemplate, RefusesWhatDoesNotFit) {
  const std::vector<Vec3> one(1, Vec3::Zero());
  EXPECT_THROW(deform_template(surface, functions.topRows(3), surface, ctx), InvalidInput);
  EXPECT_THROW(deform_template(surface, functions, surface, ctx, {}, one), InvalidInput);
  EXPECT_THROW(deform_template(surface, functions, surface, ctx, {.noise_mm = {}}), InvalidInput);
  EXPECT_THROW(deform_template(surface, functions, surface, ctx, {.noise_mm = {-1}}), InvalidInput);
  EXPECT_THROW(deform_template(surface, functions, surface, ctx, {.iterations = 0}), InvalidInput);
  EXPECT_THROW(deform_template(surface, functions, surface, ctx, {.match = {.tangential_share = 0}}),
               InvalidInput);
  EXPECT_THROW(deform_template(surface, functions, surface, ctx, {}, {}, {.mean = Eigen::VectorXd::Zero(1)}),
               InvalidInput);
}

}  // namespace
}  // namespace foramen
