#include "correspond/template_metric.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "correspond/mean_template.hpp"
#include "correspond/template_surface.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "parameterize/optimise_map.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/mapped_tori.hpp"

namespace foramen {
namespace {

int flipped_triangles(const TemplateSurface& surface) {
  int count = 0;
  for (FaceId f : surface.mesh.faces())
    if (!(signed_area(surface.mesh, surface.map, f) > 0)) ++count;
  return count;
}

TEST(MetricTensors, GiveLengthsOnTheTemplate) {
  const auto torus = testing::wavy_torus(3000);
  const VertexMap<Mat2> tensors = metric_tensors({torus.mesh, torus.map});
  double got = 0, expected = 0, worst = 0;
  for (EdgeId e : torus.mesh.edges()) {
    const HalfedgeId h = torus.mesh.halfedge(e);
    const VertexId a = torus.mesh.from(h), b = torus.mesh.to(h);
    const Vec2 edge =
        torus.map.lattice * (torus.map.turns[b] + torus.map.jumps[h].cast<double>() - torus.map.turns[a]);
    const double length = std::sqrt(edge.dot(0.5 * (tensors[a] + tensors[b]) * edge));
    got += length;
    expected += edge_length(torus.mesh, e);
    worst = std::max(worst, std::abs(length - edge_length(torus.mesh, e)) / edge_length(torus.mesh, e));
  }
  EXPECT_NEAR(got, expected, 0.01 * expected);
  EXPECT_LT(worst, 0.1);
}

TEST(TemplateMetric, ToItselfTheIdentityHasNoDistortionButThatOfInterpolation) {
  const auto torus = testing::wavy_torus(6000);
  const TemplateMetric metric({torus.mesh, torus.map});
  const TargetMetric at = metric.at(torus.mesh, torus.map);
  EXPECT_NEAR(at.area, total_area(torus.mesh), 1e-9);
  const RunContext ctx(1);
  const OptimisedMap same = optimise_map(torus.mesh, torus.map, ctx, {.iteration_limit = 1}, nullptr, &at);
  EXPECT_NEAR(same.initial_energy, 4, 0.01);
  // Measured in the flat plane, the same map is distorted.
  EXPECT_GT(optimise_map(torus.mesh, torus.map, ctx, {.iteration_limit = 1}).initial_energy, 4.2);
}

TEST(TargetMetricOfOptimiseMap, AConstantMultipleOfThePlaneChangesNothing) {
  const auto torus = testing::wavy_torus(400);
  const TargetMetric flat{FaceMap<Mat2>(torus.mesh.face_count(), 50 * Mat2::Identity()), 2500};
  const RunContext ctx(1);
  const OptimisedMap a = optimise_map(torus.mesh, torus.map, ctx);
  const OptimisedMap b = optimise_map(torus.mesh, torus.map, ctx, {}, nullptr, &flat);
  EXPECT_NEAR(a.final_energy, b.final_energy, 1e-6);
  for (VertexId v : torus.mesh.vertices()) EXPECT_LT((a.map.turns[v] - b.map.turns[v]).norm(), 1e-5);
}

TEST(TargetMetricOfOptimiseMap, IsRefusedWhereItDoesNotFit) {
  const auto torus = testing::wavy_torus(400);
  const RunContext ctx(1);
  TargetMetric metric{FaceMap<Mat2>(torus.mesh.face_count(), Mat2::Identity()), 1};
  EXPECT_THROW(optimise_map(torus.mesh, torus.map, ctx, {.free_lattice = true}, nullptr, &metric),
               InvalidInput);
  metric.to_target[FaceId(3)] = -Mat2::Identity() * Mat2(Vec2(1, -1).asDiagonal());
  EXPECT_THROW(optimise_map(torus.mesh, torus.map, ctx, {}, nullptr, &metric), InvalidInput);
  metric.to_target = FaceMap<Mat2>(3, Mat2::Identity());
  EXPECT_THROW(optimise_map(torus.mesh, torus.map, ctx, {}, nullptr, &metric), InvalidInput);
}

TEST(MeanTemplate, OfMovedCopiesIsTheSurfaceItself) {
  const auto torus = testing::wavy_torus(4000);
  RigidTransform motion = RigidTransform::Identity();
  motion.rotate(Eigen::AngleAxisd(0.9, Vec3(1, 1, -2).normalized())).pretranslate(Vec3(10, 20, 30));
  const TorusLocator a(torus.mesh, torus.map), b(transformed(torus.mesh, motion), torus.map);
  const std::vector<const TorusLocator*> shapes{&a, &b};
  const RunContext ctx(1);
  const MeanTemplate mean =
      mean_template(shapes, torus.map.lattice, ctx, {.vertices = 800, .grid_points = 5000});
  EXPECT_EQ(mean.surface.mesh.vertex_count(), 800);
  EXPECT_EQ(flipped_triangles(mean.surface), 0);
  // Each template vertex lies where both shapes have its torus position.
  for (VertexId v : mean.surface.mesh.vertices()) {
    const Vec3 lifted = position(torus.mesh, a.locate(mean.surface.map.turns[v]));
    EXPECT_LT((mean.transforms[0](lifted) - mean.surface.mesh.position(v)).norm(), 0.15);
    EXPECT_LT((mean.transforms[1](motion * lifted) - mean.surface.mesh.position(v)).norm(), 0.15);
  }
}

}  // namespace
}  // namespace foramen
