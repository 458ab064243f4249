#include "modelfiles/usable_model.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "foramen/apply/project_shape.hpp"
#include "foramen/core/error.hpp"
#include "support/real_meshes.hpp"
#include "support/temporary_folder.hpp"
#include "workflow/read_family.hpp"

namespace foramen {
namespace {

class UsableModelTest : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new testing::TemporaryFolder;
    build_ = new BuildRecord(testing::family_build(testing::small()));
    write_model_files(folder_->path(), *build_, "foramen build", 1);
  }
  static void TearDownTestSuite() {
    delete build_;
    delete folder_;
  }
  static const testing::TemporaryFolder& folder() { return *folder_; }
  static const BuildRecord& build() { return *build_; }

 private:
  static inline testing::TemporaryFolder* folder_ = nullptr;
  static inline BuildRecord* build_ = nullptr;
};

double rms(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]).squaredNorm();
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST_F(UsableModelTest, HoldsTheShapesThatTheModelWasMadeOf) {
  const UsableModel model = read_usable_model(folder().path());
  ASSERT_EQ(model.names.size(), build().inputs.size());
  for (std::size_t i = 0; i < model.names.size(); ++i) {
    EXPECT_EQ(model.names[i], build().inputs[i].stem);
    EXPECT_LT(rms(model.aligned.alignment.aligned[i], build().built.aligned.alignment.aligned[i]), 1e-3);
  }
  EXPECT_EQ(model.scale, ScaleMode::keep);
  EXPECT_EQ(model.lattice, build().built.registration.frame.reference.shape_map.map.lattice);
}

// The root mean square distance of landmarks [mm] that corresponds to the difference of two scores in
// standard deviations.
double score_distance(const UsableModel& model, double a, double b) {
  const ShapeModel& modes = model.aligned.model;
  return std::abs(a - b) * std::sqrt(modes.variance()[0] / modes.landmarks());
}

RigidTransform some_pose() {
  RigidTransform pose = RigidTransform::Identity();
  return pose.rotate(Eigen::AngleAxisd(2.0, Vec3(1, -1, 3).normalized())).pretranslate(Vec3(9, 80, -70));
}

// A training shape that is projected as a new surface in another pose gets its own landmarks, except that
// they may slide on a torus without features.
TEST_F(UsableModelTest, ANewSurfaceGetsTheLandmarksOfTheModel) {
  const UsableModel model = read_usable_model(folder().path());
  const MeanRegistrar registrar = registrar_of(model, RunContext(1));
  for (const std::size_t k : {std::size_t{1}, std::size_t{3}}) {
    const InputShape& shape = build().inputs[k];
    const std::vector<Vec3>& landmarks = build().built.landmarks.points[k];
    const std::vector<Vec3> found =
        registrar.landmarks_on(transformed(shape.mesh, some_pose()), RunContext(1));
    EXPECT_LT(rms(found, transformed(landmarks, some_pose())), 0.5) << shape.stem;
    const ProjectedShape own = project_shape(landmarks, model.aligned, model.scale),
                         again = project_shape(found, model.aligned, model.scale);
    EXPECT_LT(score_distance(model, own.scores[0], again.scores[0]), 0.2) << shape.stem;
  }
}

// On vertebrae, which have features, every score is recovered.
TEST(UsableModel, RealDataScoresOfATrainingShapeComeBack) {
  FORAMEN_NEEDS_REAL_DATA();
  Cohort cohort;
  for (const std::string stem : {"verse005_L1", "verse005_L2", "verse561_L1", "verse561_L2", "verse561_L3"}) {
    InputShape& input = cohort.shapes.emplace_back();
    input.stem = stem;
    input.file_name = stem + ".ply";
    input.mesh = testing::real_mesh("lumbar/" + stem);
  }
  BuildOptions options = testing::small();
  const BuildRecord built = build_from(std::move(cohort), options, RunContext(2));
  const testing::TemporaryFolder model_folder;
  write_model_files(model_folder.path(), built, "foramen build", 1);
  const UsableModel model = read_usable_model(model_folder.path());
  const MeanRegistrar registrar = registrar_of(model, RunContext(1));
  for (const std::size_t k : {std::size_t{1}, std::size_t{4}}) {
    const InputShape& shape = built.inputs[k];
    const std::vector<Vec3>& landmarks = built.built.landmarks.points[k];
    const ProjectedShape own = project_shape(landmarks, model.aligned, model.scale),
                         again = project_shape(
                             registrar.landmarks_on(transformed(shape.mesh, some_pose()), RunContext(1)),
                             model.aligned, model.scale);
    for (Eigen::Index m = 0; m < own.scores.size(); ++m)
      EXPECT_NEAR(own.scores[m], again.scores[m], 0.2) << shape.stem << ", mode " << m + 1;
  }
}

TEST_F(UsableModelTest, AnotherTopologyIsRefused) {
  const MeanRegistrar registrar = registrar_of(read_usable_model(folder().path()), RunContext(1));
  const TriangleSoup octahedron{
      {{20, 0, 0}, {-20, 0, 0}, {0, 20, 0}, {0, -20, 0}, {0, 0, 20}, {0, 0, -20}},
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  EXPECT_THROW(registrar.landmarks_on(build_mesh(octahedron), RunContext(1)), Error);
}

TEST_F(UsableModelTest, FilesOfTwoModelsAreRefused) {
  const testing::TemporaryFolder mixed;
  BuildOptions fewer = testing::small();
  fewer.landmarks.count = 300;
  write_model_files(mixed.path(), testing::family_build(fewer), "foramen build", 1);
  std::filesystem::copy_file(folder().path() / "atlas.h5", mixed.path() / "atlas.h5",
                             std::filesystem::copy_options::overwrite_existing);
  EXPECT_THROW(read_usable_model(mixed.path()), IoError);
}

}  // namespace
}  // namespace foramen
