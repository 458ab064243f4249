#include "foramen/correspond/mean_registrar.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "correspond/feature_targets.hpp"
#include "correspond/knobbly_family.hpp"
#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/spatial/triangle_tree.hpp"

namespace foramen {
namespace {

constexpr int mean_landmarks = 1000;

RegisterGroupOptions quick_registration() {
  RegisterGroupOptions options;
  options.working_vertices = 1500;
  return options;
}

TemplateSurface mean_member() {
  testing::MappedSurface mean = testing::member_surface(1, mean_landmarks);
  return {std::move(mean.mesh), std::move(mean.map)};
}

MeanRegistrar registrar_to(const TemplateSurface& mean, int threads = 1) {
  std::vector<std::vector<Vec3>> training;
  for (const double strength : testing::training_strengths)
    training.push_back(testing::on_member(mean_member().map.turns.values(), strength));
  return {mean, training, RunContext(threads), quick_registration()};
}

std::vector<Vec3> true_landmarks_of(double strength) {
  return testing::on_member(mean_member().map.turns.values(), strength);
}

double rms_distance(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b.at(i)).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

RigidTransform another_pose() {
  RigidTransform pose = RigidTransform::Identity();
  pose.rotate(Eigen::AngleAxisd(2.0, Vec3(1, -1, 3).normalized())).pretranslate(Vec3(9, 80, -70));
  return pose;
}

TEST(MeanRegistrar, FindsTheTrueLandmarksOfAMemberInAnyPose) {
  const MeanRegistrar registrar = registrar_to(mean_member());
  const Mesh here = testing::new_member(1.25), there = transformed(here, another_pose());
  const std::vector<Vec3> found = registrar.landmarks_on(here, RunContext(1));
  ASSERT_EQ(found.size(), true_landmarks_of(1.25).size());
  EXPECT_LT(rms_distance(found, true_landmarks_of(1.25)), 0.3);
  // The landmarks of the mean itself are farther from the true ones.
  EXPECT_GT(rms_distance(true_landmarks_of(1), true_landmarks_of(1.25)), 0.8);
  const TriangleTree surface(here);
  for (const Vec3& p : found) EXPECT_LT(std::sqrt(surface.closest(p).squared_distance), 1e-9);
  EXPECT_LT(rms_distance(registrar.landmarks_on(there, RunContext(1)), transformed(found, another_pose())),
            1e-6);
}

// The loops that are found determine the basis of periods of the mean's map, so results must not depend on
// this basis.
TEST(MeanRegistrar, TheBasisOfTheMeansMapDoesNotMatter) {
  const TemplateSurface mean = mean_member();
  Eigen::Matrix2i b;
  b << 1, 1, 0, 1;
  const TemplateSurface sheared{mean.mesh, change_basis(mean.map, b)};
  ASSERT_NE(sheared.map.jumps, mean.map.jumps);
  const Mesh member = testing::new_member(0.9);
  EXPECT_LT(rms_distance(registrar_to(mean).landmarks_on(member, RunContext(1)),
                         registrar_to(sheared).landmarks_on(member, RunContext(1))),
            1e-8);
}

// The curvatures of another shape's places draw the map away from the true landmarks.
TEST(MeanRegistrar, TakesTheCurvaturesThatItIsGiven) {
  TemplateSurface mean = mean_member();
  const Mesh member = testing::new_member(0.9);
  const std::vector<Vec3> by_mesh = registrar_to(mean).landmarks_on(member, RunContext(1));
  mean.curvatures = curvature_features(mean.mesh, quick_registration().features);
  EXPECT_EQ(registrar_to(mean).landmarks_on(member, RunContext(1)), by_mesh);
  std::rotate(mean.curvatures.values().begin(), mean.curvatures.values().begin() + 100,
              mean.curvatures.values().end());
  EXPECT_GT(rms_distance(registrar_to(mean).landmarks_on(member, RunContext(1)), by_mesh), 0.02);
}

TEST(MeanRegistrar, ThreadsAndMovesChangeNothing) {
  MeanRegistrar one = registrar_to(mean_member(), 1), two = registrar_to(mean_member(), 2);
  const Mesh member = testing::new_member(0.9);
  const std::vector<Vec3> found = one.landmarks_on(member, RunContext(1));
  EXPECT_EQ(two.landmarks_on(member, RunContext(2)), found);
  const MeanRegistrar moved(std::move(one));
  EXPECT_EQ(moved.landmarks_on(member, RunContext(1)), found);
}

TEST(MeanRegistrar, RefusesAMeanThatCannotBeATemplate) {
  const TemplateSurface mean = mean_member();
  TriangleSoup open = mean.mesh.soup();
  open.triangles.pop_back();
  TorusMap map = mean.map;
  map.jumps.values().resize(map.jumps.values().size() - 3);
  EXPECT_THROW(MeanRegistrar({build_mesh(open), map}, {}, RunContext(1)), TopologyError);
  const std::vector<std::vector<Vec3>> too_short(3, std::vector<Vec3>(7, Vec3::Zero()));
  EXPECT_THROW(MeanRegistrar(mean, too_short, RunContext(1), quick_registration()), InvalidInput);
}

TEST(MeanRegistrar, RefusesASurfaceOfAnotherTopologyAndStopsWhenAsked) {
  const MeanRegistrar registrar = registrar_to(mean_member());
  const TriangleSoup octahedron{
      {{20, 0, 0}, {-20, 0, 0}, {0, 20, 0}, {0, -20, 0}, {0, 0, 20}, {0, 0, -20}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  EXPECT_THAT([&] { registrar.landmarks_on(build_mesh(octahedron), RunContext(1)); },
              ::testing::ThrowsMessage<TopologyError>(::testing::HasSubstr("genus 0")));
  TriangleSoup open = testing::new_member(1).soup();
  open.triangles.pop_back();
  EXPECT_THAT([&] { registrar.landmarks_on(build_mesh(open), RunContext(1)); },
              ::testing::ThrowsMessage<TopologyError>(::testing::HasSubstr("not closed")));
  const RunContext stopped(1);
  stopped.request_stop();
  EXPECT_THROW(registrar.landmarks_on(testing::new_member(1), stopped), Cancelled);
}

}  // namespace
}  // namespace foramen
