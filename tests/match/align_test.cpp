#include "foramen/match/align.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/SVD>

#include "foramen/core/error.hpp"
#include "foramen/core/rng.hpp"
#include "match/principal_frame.hpp"
#include "match/rigid_step.hpp"
#include "support/meshes.hpp"
#include "support/real_meshes.hpp"

namespace foramen {
namespace {

using std::numbers::pi;

// A torus that no rotation maps onto itself, with a blunt spike of length `long_process` [mm] on one side.
TriangleSoup odd_torus(int around, int tube, double long_process = 0) {
  TriangleSoup soup = testing::torus_soup(around, tube);
  for (Vec3& p : soup.points) {
    const double u = std::atan2(p.y(), p.x()), radius = std::hypot(p.x(), p.y());
    p *= 1 + 0.15 * std::cos(2 * u + 0.4) + 0.1 * std::cos(3 * u);
    p.z() += 3 * std::sin(u + 1);
    const double tip = std::exp(-std::pow((u - 2) / 0.25, 2)) * std::max(0.0, radius - 20) / 8;
    p += (8 + long_process) * tip * Vec3(std::cos(u), std::sin(u), 0.3);
  }
  return soup;
}

RigidTransform random_pose(Rng& rng) {
  const Eigen::Quaterniond q(rng.normal(), rng.normal(), rng.normal(), rng.normal());
  const auto place = [&] { return rng.uniform(-300, 300); };
  return Eigen::Translation3d(place(), place(), place()) * q.normalized();
}

// The largest distance between the positions of a vertex after two motions.
double difference(const Mesh& mesh, const RigidTransform& a, const RigidTransform& b) {
  double largest = 0;
  for (const Vec3& p : mesh.positions()) largest = std::max(largest, (a * p - b * p).norm());
  return largest;
}

double angle(const RigidTransform& motion) { return Eigen::AngleAxisd(motion.linear()).angle(); }

const RunContext ctx(1);

TEST(Align, BringsAMovedCopyBack) {
  const Mesh fixed = build_mesh(odd_torus(60, 30));
  Rng rng(1);
  for (int i = 0; i < 5; ++i) {
    const RigidTransform pose = random_pose(rng);
    const Alignment found = align(transformed(fixed, pose), fixed, ctx);
    EXPECT_TRUE(found.converged);
    EXPECT_LT(difference(fixed, found.transform * pose, RigidTransform::Identity()), 1e-3);
    EXPECT_GT(found.second_best, 1.5 * found.residual);
  }
}

TEST(Align, TheResultDoesNotDependOnThePose) {
  const Mesh fixed = build_mesh(odd_torus(60, 30)), moving = build_mesh(odd_torus(48, 24, 6));
  const Alignment expected = align(moving, fixed, ctx);
  Rng rng(2);
  for (int i = 0; i < 3; ++i) {
    const RigidTransform pose = random_pose(rng);
    const Alignment found = align(transformed(moving, pose), fixed, ctx);
    EXPECT_LT(difference(moving, found.transform * pose, expected.transform), 1e-3);
    EXPECT_NEAR(found.residual, expected.residual, 1e-6);
    const RigidTransform there = random_pose(rng);
    const Alignment moved_reference = align(moving, transformed(fixed, there), ctx);
    EXPECT_LT(difference(moving, moved_reference.transform, there * expected.transform), 1e-3);
  }
}

TEST(Align, ExchangingTheShapesInvertsTheMotion) {
  const Mesh fixed = build_mesh(odd_torus(60, 30)), moving = build_mesh(odd_torus(48, 24, 6));
  const Alignment there = align(moving, fixed, ctx), back = align(fixed, moving, ctx);
  EXPECT_LT(difference(moving, back.transform * there.transform, RigidTransform::Identity()), 5e-3);
  EXPECT_NEAR(there.residual, back.residual, 1e-3);
}

// The least-squares motion for the true matches, vertex by vertex.
RigidTransform least_squares(const Mesh& moving, const Mesh& fixed) {
  const auto columns = [](const Mesh& mesh) {
    Eigen::Matrix3Xd points(3, mesh.vertex_count());
    for (VertexId v : mesh.vertices()) points.col(v.index) = mesh.position(v);
    return points;
  };
  return RigidTransform(Eigen::umeyama(columns(moving), columns(fixed), false));
}

TEST(Align, AProcessThatTheOtherLacksPullsLittle) {
  // The vertices are about half a millimetre apart, as on real vertebrae, because their spacing affects the
  // robust scale.
  const Mesh fixed = build_mesh(odd_torus(240, 120)), moving = build_mesh(odd_torus(240, 120, 12));
  const RigidTransform same = RigidTransform::Identity();
  const double plain_pull = difference(fixed, least_squares(moving, fixed), same);
  ASSERT_GT(plain_pull, 0.4);
  EXPECT_LT(difference(fixed, align(moving, fixed, ctx).transform, same), plain_pull / 4);
}

TEST(Align, AnotherTriangulationOfTheSameSurface) {
  const Mesh fixed = build_mesh(odd_torus(80, 40));
  Rng rng(3);
  const RigidTransform pose = random_pose(rng);
  const Mesh moving = transformed(build_mesh(testing::renumbered(odd_torus(66, 30), 5)), pose);
  EXPECT_LT(difference(fixed, align(moving, fixed, ctx).transform * pose, RigidTransform::Identity()), 0.1);
}

TEST(Align, SurfacesOfRevolutionAreAmbiguousAndSaySo) {
  const Mesh torus = build_mesh(testing::torus_soup(48, 24));
  const Alignment found = align(torus, torus, ctx);
  EXPECT_LT(found.second_best, 1.1 * found.residual + 0.1);
}

TEST(Align, NeverMirrors) {
  const Mesh fixed = build_mesh(odd_torus(60, 30));
  TriangleSoup soup = fixed.soup();
  for (Vec3& p : soup.points) p.x() = -p.x();
  const Alignment found = align(reversed(build_mesh(std::move(soup))), fixed, ctx);
  EXPECT_NEAR(found.transform.linear().determinant(), 1, 1e-9);
  EXPECT_LT((found.transform.linear() * found.transform.linear().transpose() - Mat3::Identity()).norm(),
            1e-9);
}

TEST(Align, ALimitIsNotConvergence) {
  const Mesh fixed = build_mesh(odd_torus(60, 30)), moving = build_mesh(odd_torus(48, 24, 6));
  AlignOptions options;
  options.iteration_limit = 1;
  const Alignment found = align(moving, fixed, ctx, options);
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.iterations, 1);
}

TEST(Align, RefusesWhatItCannotUse) {
  const Mesh torus = build_mesh(testing::torus_soup(12, 8));
  EXPECT_THROW(align(torus, torus, ctx, {.normal_weight = -1}), InvalidInput);
  EXPECT_THROW(align(torus, torus, ctx, {.sample_points = 1}), InvalidInput);
  EXPECT_THROW(align(torus, torus, ctx, {.iteration_limit = -1}), InvalidInput);
  EXPECT_THROW(align(torus, torus, ctx, {.tolerance = -1}), InvalidInput);
  EXPECT_THROW(align(Mesh(), torus, ctx), InvalidInput);
}

TEST(Align, CanBeStopped) {
  const Mesh torus = build_mesh(testing::torus_soup(12, 8));
  const RunContext stopped(1);
  stopped.request_stop();
  EXPECT_THROW(align(torus, torus, stopped), Cancelled);
}

TEST(Align, RealVertebraeFromAnyPose) {
  FORAMEN_NEEDS_REAL_DATA();
  const Mesh fixed = testing::real_mesh("lumbar/verse005_L2");
  Rng rng(4);
  // Vertebrae of other subjects and levels, including the most different one.
  for (const char* name : {"lumbar/verse581_L1", "lumbar/verse631_L5", "thoracic/verse561_T4"}) {
    SCOPED_TRACE(name);
    const Mesh moving = testing::real_mesh(name);
    const RigidTransform pose = random_pose(rng);
    const Alignment here = align(moving, fixed, ctx), there = align(transformed(moving, pose), fixed, ctx);
    EXPECT_TRUE(here.converged);
    EXPECT_LT(difference(moving, there.transform * pose, here.transform), 0.05);
    // All subjects were scanned lying on the back. Therefore, left and head keep their directions, except for
    // the curvature of the spine.
    EXPECT_GT(here.transform.linear()(0, 0), 0.95);
    EXPECT_LT(angle(here.transform), 40 * pi / 180);
    EXPECT_GT(here.second_best, 1.05 * here.residual);
  }
}

std::vector<detail::Match> matches_of(const std::vector<Vec3>& moving, const RigidTransform& to, Rng& rng) {
  std::vector<detail::Match> matches;
  for (const Vec3& p : moving) {
    const Vec3 normal = Vec3(rng.normal(), rng.normal(), rng.normal()).normalized(), fixed = to * p;
    matches.push_back({p, fixed, normal, (p - fixed).norm()});
  }
  return matches;
}

std::vector<Vec3> random_points(int count, Rng& rng) {
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
    points.emplace_back(30 * rng.normal(), 20 * rng.normal(), 10 * rng.normal());
  return points;
}

TEST(RigidStep, FindsASmallMotion) {
  Rng rng(5);
  const auto points = random_points(60, rng);
  const RigidTransform small =
      Eigen::Translation3d(0.02, -0.01, 0.03) * Eigen::AngleAxisd(1e-4, Vec3(1, 2, 3).normalized());
  const auto matches = matches_of(points, small, rng);
  const std::vector<double> ones(points.size(), 1.0);
  const auto error = [&](const RigidTransform& motion) {
    double largest = 0;
    for (const Vec3& p : points) largest = std::max(largest, (motion * p - small * p).norm());
    return largest;
  };
  const double second_order =
      5e-6;  // terms of second order: angle times translation, and angle^2 times size; the motion is 0.04
  for (double share : {0.0, 0.1, 1.0})
    EXPECT_LT(error(detail::rigid_step(matches, ones, {.point_share = share})), second_order);
  const RigidTransform half = detail::rigid_step(matches, ones, {.length = 0.5});
  EXPECT_LT(error(half * half), second_order);
}

TEST(RigidStep, WeightZeroMeansAbsent) {
  Rng rng(6);
  const auto points = random_points(40, rng);
  auto matches = matches_of(points, RigidTransform(Eigen::Translation3d(0.1, 0, 0)), rng);
  std::vector<double> weights(points.size(), 1.0);
  matches[7].fixed += Vec3(50, 50, 50);
  weights[7] = 0;
  const RigidTransform step = detail::rigid_step(matches, weights);
  EXPECT_LT((step.translation() - Vec3(0.1, 0, 0)).norm(), 1e-9);
  const std::vector<double> none(points.size(), 0.0);
  EXPECT_TRUE(detail::rigid_step(matches, none).isApprox(RigidTransform::Identity()));
}

TEST(TukeyWeights, OneAtZeroNoneBeyondTheReach) {
  std::vector<detail::Match> matches(9);
  for (std::size_t i = 0; i < 9; ++i) matches[i].distance = static_cast<double>(i);
  matches[8].distance = 1000;
  const auto w = detail::tukey_weights(matches, 0.1);
  EXPECT_EQ(w[0], 1);
  EXPECT_EQ(w[8], 0);
  for (std::size_t i = 1; i < 3; ++i) EXPECT_LT(w[i], w[i - 1]);
  const double reach = 4.685 * 1.4826 * 4;  // the median is 4
  EXPECT_NEAR(w[6], std::pow(1 - 36 / (reach * reach), 2), 1e-12);
}

TEST(PrincipalFrame, MovesWithTheMesh) {
  const Mesh mesh = build_mesh(odd_torus(40, 20));
  Rng rng(7);
  const RigidTransform pose = random_pose(rng);
  const auto here = detail::principal_frame(mesh), there = detail::principal_frame(transformed(mesh, pose));
  EXPECT_LT((pose * here.centre - there.centre).norm(), 1e-9);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(std::abs((pose.linear() * here.axes.col(k)).dot(there.axes.col(k))), 1, 1e-9);
  EXPECT_NEAR(here.axes.determinant(), 1, 1e-12);
}

TEST(PrincipalFrame, TheMatchingsAreTheRotationGroupOfTheCube) {
  const auto group = detail::proper_matchings();
  ASSERT_EQ(group.size(), 24u);
  for (const Mat3& a : group) {
    EXPECT_EQ(a.determinant(), 1);
    EXPECT_EQ(std::count(group.begin(), group.end(), a), 1);
    for (const Mat3& b : group) EXPECT_EQ(std::count(group.begin(), group.end(), Mat3(a * b)), 1);
  }
}

}  // namespace
}  // namespace foramen
