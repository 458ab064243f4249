#include "foramen/stages/refit.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <tuple>

#include "foramen/core/error.hpp"
#include "foramen/spatial/surface_distance.hpp"
#include "stages/refit_archive.hpp"
#include "support/memory_store.hpp"
#include "support/torus_family.hpp"

namespace foramen {
namespace {

using testing::family;
using ::testing::HasSubstr;

const GeneralizationOptions measure{.samples = 1000};

BuildOptions quick_build() {
  BuildOptions options = testing::small();
  options.landmarks.count = 600;
  options.landmarks.spread.grid_points = 6000;
  options.landmarks.spread.density_updates = 1;
  options.correspondence.group.mean = {.vertices = 1500, .grid_points = 6000};
  options.correspondence.group.round_limit = 1;
  return options;
}

// The family with an additional last shape, which is the second shape in another pose.
std::vector<Shape> family_with_twins() {
  std::vector<Shape> shapes = family();
  RigidTransform pose = RigidTransform::Identity();
  pose.rotate(Eigen::AngleAxisd(2, Vec3(1, -1, 3).normalized())).pretranslate(Vec3(5, 60, -20));
  shapes.push_back({"twin", transformed(shapes[1].mesh, pose)});
  return shapes;
}

std::vector<Shape> family_with_another_first() {
  std::vector<Shape> shapes = family();
  shapes[0].mesh = build_mesh(testing::lopsided_torus_soup(50, 26, 1.6));
  return shapes;
}

double representation_error(const Shape& shape, const Landmarks& landmarks, std::size_t i) {
  return surface_distance(TriangleTree(build_mesh({landmarks.points[i], landmarks.mesh.triangles})),
                          TriangleTree(shape.mesh), {.samples = 1000})
      .mean;
}

TEST(Refit, AShapeWhoseTwinIsInTheModelIsDescribedAsWellAsItIsRepresented) {
  const BuildOptions options = quick_build();
  const std::vector<Shape> shapes = family_with_twins();
  const Landmarks landmarks = build_model(shapes, options, RunContext(2)).landmarks;
  ASSERT_EQ(landmarks.names.size(), 5u);
  const RefitGeneralization refit = refit_generalization(shapes, {}, options, measure, RunContext(2));
  EXPECT_TRUE(refit.failures.empty());
  EXPECT_THAT(refit.names, ::testing::ElementsAre("s0", "s1", "s2", "s3", "twin"));
  EXPECT_EQ(refit.generalization.groups, 5);
  ASSERT_EQ(refit.generalization.by_modes.size(), 3u);  // 1 .. n - 2
  const std::vector<ShapeError>& errors = refit.generalization.by_modes.back().items;
  for (const std::size_t i : {1u, 4u}) {
    const double represented = representation_error(shapes[i], landmarks, i);
    EXPECT_LT(errors[i].mean_surface, 1.3 * represented) << refit.names[i];
  }
}

TEST(Refit, TheModelOfTheOthersDoesNotSeeTheShape) {
  BuildOptions options = quick_build();
  options.correspondence.reference = "s0";  // the reference may be left out
  const BuiltModel a = build_without(family(), {0}, quick_build(), RunContext(2));
  const BuiltModel b = build_without(family_with_another_first(), {0}, options, RunContext(1));
  ASSERT_EQ(a.landmarks.names.size(), 3u);
  EXPECT_EQ(a.landmarks.mesh.turns, b.landmarks.mesh.turns);
  EXPECT_EQ(a.registration.frame.group.grid, b.registration.frame.group.grid);
  EXPECT_EQ(a.aligned.model.mean(), b.aligned.model.mean());
  EXPECT_EQ(a.aligned.model.variance(), b.aligned.model.variance());
  EXPECT_NE(family()[0].mesh.positions()[0], family_with_another_first()[0].mesh.positions()[0])
      << "the shape is to differ";
}

TEST(Refit, OfAMemberItGivesTheLandmarksTheMemberHas) {
  for (const auto& [method, objective, largest_mm] :
       {std::tuple{Method::icp, Objective::surface, 1e-9},
        std::tuple{Method::torus, Objective::neighbours, 1e-9}}) {
    BuildOptions options = quick_build();
    options.correspondence.method = method;
    options.correspondence.objective = objective;
    const BuiltModel built = build_model(family(), options, RunContext(2));
    const std::size_t other = built.registration.reference == 0 ? 1 : 0;
    const auto landmarks = landmarks_on_newcomer(family()[other].mesh, built.registration, built.landmarks,
                                                 options.correspondence, RunContext(1));
    ASSERT_EQ(landmarks.size(), built.landmarks.points[other].size());
    for (std::size_t p = 0; p < landmarks.size(); ++p)
      EXPECT_LE((landmarks[p] - built.landmarks.points[other][p]).norm(), largest_mm);
  }
}

TEST(Refit, ShapesThatCannotEnterAreNamedWithTheReason) {
  BuildOptions options = quick_build();
  options.correspondence.method = Method::icp;
  GeneralizationOptions by_subject = measure;
  by_subject.leave_out = LeaveOut::subject;
  const RefitGeneralization refit =
      refit_generalization(family(), {"a", "a", "b", "c"}, options, by_subject, RunContext(2));
  EXPECT_THAT(refit.names, ::testing::ElementsAre("s2", "s3"));
  EXPECT_EQ(refit.generalization.groups, 2);
  ASSERT_EQ(refit.failures.size(), 2u);
  EXPECT_EQ(refit.failures[1].shape, "s1");
  EXPECT_EQ(refit.failures[1].without, "a");
  EXPECT_THAT(refit.failures[1].reason, HasSubstr("at least 3"));
  ASSERT_EQ(refit.generalization.by_modes.size(), 2u);
  EXPECT_EQ(refit.generalization.by_modes[0].items.size(), 2u);
}

TEST(Refit, GroupsDoneBeforeAreTakenUp) {
  BuildOptions options = quick_build();
  options.correspondence.method = Method::icp;
  GeneralizationOptions by_subject = measure;
  by_subject.leave_out = LeaveOut::subject;
  const auto refit = [&](const RunContext& ctx) {
    const RefitGeneralization r =
        refit_generalization(family(), {"a", "a", "b", "c"}, options, by_subject, ctx);
    ByteWriter bytes;
    bytes(r.names, r.failures);
    for (const ErrorsAtModes& e : r.generalization.by_modes)
      for (const ShapeError& s : e.items) bytes(e.modes, s.hausdorff, s.mean_surface, s.landmark_rms);
    return bytes.take();
  };
  const auto store = std::make_shared<testing::MemoryStore>();
  const RunContext first = RunContext(1).with_store(store);
  store->stop(first, 2);
  EXPECT_THROW(refit(first), Cancelled);
  const std::string resumed = refit(RunContext(2).with_store(store));
  EXPECT_EQ(store->loads, 2);
  EXPECT_EQ(store->size(), 3);
  EXPECT_EQ(resumed, refit(RunContext(1)));
}

TEST(Refit, AStopRequestReachesTheBuilds) {
  BuildOptions options = quick_build();
  options.correspondence.method = Method::icp;
  const RunContext stopped(1);
  stopped.request_stop();
  EXPECT_THROW(refit_generalization(family(), {}, options, measure, stopped), Cancelled);
}

}  // namespace
}  // namespace foramen
