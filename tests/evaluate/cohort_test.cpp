#include "foramen/evaluate/cohort.hpp"

#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "foramen/core/geometry.hpp"
#include "support/meshes.hpp"

namespace foramen {
namespace {

Shape torus_named(const std::string& name, double minor_mm) {
  return {name, build_mesh(testing::torus_soup(12, 8, 20, minor_mm))};
}

Landmarks landmarks_of(const std::vector<Shape>& shapes) {
  Landmarks landmarks;
  for (const Shape& shape : shapes) {
    landmarks.names.push_back(shape.name);
    landmarks.points.emplace_back(shape.mesh.positions().begin(), shape.mesh.positions().end());
  }
  landmarks.mesh.triangles = shapes.front().mesh.triangles();
  return landmarks;
}

TEST(CorrespondingCohort, FindsTheSurfaceOfEveryNameWhateverTheirOrder) {
  const std::vector<Shape> shapes{torus_named("a", 7), torus_named("b", 8), torus_named("c", 9)};
  const Landmarks landmarks = landmarks_of(shapes);
  const std::vector<Shape> others{shapes[2], torus_named("left out", 5), shapes[0], shapes[1]};
  const CorrespondingCohort cohort = corresponding_cohort(others, landmarks, {"x", "y", "z"});
  check_cohort(cohort);
  EXPECT_EQ(cohort.names, landmarks.names);
  EXPECT_EQ(cohort.subjects, (std::vector<std::string>{"x", "y", "z"}));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(signed_volume(cohort.inputs[i]), signed_volume(shapes[i].mesh));
    EXPECT_EQ(signed_volume(corresponding_mesh(cohort, i)), signed_volume(shapes[i].mesh));
  }
  EXPECT_THROW(corresponding_cohort(std::vector<Shape>{shapes[0], shapes[1]}, landmarks), InvalidInput);
}

TEST(AlignCohort, MovesEverySurfaceWithItsLandmarks) {
  std::vector<Shape> shapes{torus_named("a", 7), torus_named("b", 8), torus_named("c", 9)};
  RigidTransform pose = RigidTransform::Identity();
  pose.rotate(Eigen::AngleAxisd(0.7, Vec3::UnitY())).pretranslate(Vec3(4, 5, 6));
  shapes[1].mesh = transformed(shapes[1].mesh, pose);
  for (const ScaleMode scale : {ScaleMode::keep, ScaleMode::remove}) {
    const AlignedCohort aligned = align_cohort(corresponding_cohort(shapes, landmarks_of(shapes)), scale);
    for (std::size_t i = 0; i < shapes.size(); ++i)
      for (VertexId v : aligned.inputs[i].vertices())
        EXPECT_LT((aligned.inputs[i].position(v) - aligned.alignment.aligned[i][v.index]).norm(), 1e-10);
  }
}

TEST(TransformedBySimilarity, VolumeGrowsWithTheCubeOfTheScale) {
  const Mesh mesh = build_mesh(testing::torus_soup(12, 8));
  SimilarityTransform transform;
  transform.scale = 1.5;
  transform.rotation = Eigen::AngleAxisd(0.4, Vec3(1, 1, 0).normalized()).toRotationMatrix();
  transform.translation = Vec3(1, -2, 3);
  const Mesh moved = transformed(mesh, transform);
  EXPECT_NEAR(signed_volume(moved), 1.5 * 1.5 * 1.5 * signed_volume(mesh), 1e-9 * signed_volume(moved));
  EXPECT_LT((moved.position(VertexId(3)) - transform(mesh.position(VertexId(3)))).norm(), 1e-12);
}

}  // namespace
}  // namespace foramen
