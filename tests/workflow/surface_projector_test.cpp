#include "workflow/surface_projector.hpp"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "correspond/knobbly_family.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

// A model with one mode, whose shapes are known in closed form.
UsableModel model_of_members() {
  const testing::MappedSurface mean = testing::member_surface(1, 800);
  UsableModel model;
  std::vector<std::vector<Vec3>> shapes;
  for (const double strength : testing::training_strengths) {
    model.names.push_back("member" + std::to_string(static_cast<int>(std::lround(10 * strength))));
    shapes.push_back(testing::on_member(mean.map.turns.values(), strength));
  }
  model.landmarks = {mean.map.turns.values(), mean.mesh.triangles(), mean.map.jumps};
  model.lattice = mean.map.lattice;
  model.aligned.alignment = procrustes(shapes, ScaleMode::keep);
  model.aligned.model = model_of_aligned(model.aligned.alignment.aligned, model.landmarks.triangles);
  return model;
}

class ProjectSurface : public ::testing::Test {
 protected:
  static void SetUpTestSuite() {
    projector_ = new SurfaceProjector(model_of_members(), RunContext(2));
    surface_ = new Mesh(testing::new_member(1.2));
    projection_ = new Projection((*projector_)(*surface_, left_out(), RunContext(1)));
  }
  static void TearDownTestSuite() {
    delete projection_;
    delete surface_;
    delete projector_;
  }
  static std::vector<std::string> left_out() { return {"member11", "member13"}; }
  static const SurfaceProjector& projector() { return *projector_; }
  static const Mesh& surface() { return *surface_; }
  static const Projection& projection() { return *projection_; }
  static TriangleTree mesh_of(const std::vector<Vec3>& landmarks) {
    return TriangleTree(build_mesh({landmarks, projector().model().landmarks.triangles}));
  }

 private:
  static inline SurfaceProjector* projector_ = nullptr;
  static inline Mesh* surface_ = nullptr;
  static inline Projection* projection_ = nullptr;
};

void expect_same_distance(const SurfaceDistance& a, const SurfaceDistance& b) {
  EXPECT_EQ(a.mean, b.mean);
  EXPECT_EQ(a.p95, b.p95);
  EXPECT_EQ(a.hausdorff, b.hausdorff);
}

TEST_F(ProjectSurface, AMemberIsDescribedByTheModesOfItsFamily) {
  const Projection& p = projection();
  const std::vector<Vec3> expected = testing::on_member(projector().model().landmarks.turns, 1.2);
  ASSERT_EQ(p.landmarks.size(), expected.size());
  double sum = 0;
  for (std::size_t i = 0; i < expected.size(); ++i) sum += (p.landmarks[i] - expected[i]).squaredNorm();
  EXPECT_LT(std::sqrt(sum / static_cast<double>(expected.size())), 0.3);
  const ProjectedShape known = project_shape(expected, projector().model().aligned, ScaleMode::keep);
  // One standard deviation moves the landmarks by 0.9 mm (RMS).
  EXPECT_NEAR(p.shape.scores[0], known.scores[0], 0.3);
  EXPECT_LT(p.fit.mean, 0.2);
}

TEST_F(ProjectSurface, EveryFigureIsThatOfItsDefinition) {
  const Projection& p = projection();
  const UsableModel& model = projector().model();
  const ProjectedShape shape = project_shape(p.landmarks, model.aligned, model.scale);
  EXPECT_EQ(p.shape.scores, shape.scores);
  EXPECT_EQ(p.shape.fit, shape.fit);
  const TriangleTree surface_tree(surface());
  expect_same_distance(p.representation, surface_distance(surface_tree, mesh_of(p.landmarks)));
  expect_same_distance(p.fit, surface_distance(surface_tree, mesh_of(shape.fit)));
  const TriangleTree fit = mesh_of(shape.fit);
  ASSERT_EQ(p.residual.size(), surface().vertex_count());
  for (const VertexId v : surface().vertices())
    EXPECT_EQ(p.residual[v.index], std::sqrt(fit.closest(surface().position(v)).squared_distance));
  ASSERT_EQ(p.fit_residual.size(), shape.fit.size());
  for (std::size_t i = 0; i < shape.fit.size(); ++i)
    EXPECT_EQ(p.fit_residual[i], std::sqrt(surface_tree.closest(shape.fit[i]).squared_distance));
}

TEST_F(ProjectSurface, LeftOutShapesAreNotInTheModelTheSecondFitIsOf) {
  const Projection& p = projection();
  const AlignedModel others = projector().without(left_out());
  EXPECT_EQ(others.alignment.aligned.size(), 2u);
  ASSERT_TRUE(p.fit_without_left_out);
  EXPECT_EQ(p.left_out, left_out());
  expect_same_distance(*p.fit_without_left_out,
                       surface_distance(TriangleTree(surface()),
                                        mesh_of(project_shape(p.landmarks, others, ScaleMode::keep).fit)));
  const std::vector<std::string> unknown{"nobody"};
  EXPECT_THROW(projector().without(unknown), InvalidInput);
  EXPECT_THROW(projector()(surface(), unknown, RunContext(1)), InvalidInput);
}

TEST_F(ProjectSurface, JsonHasTheFiguresAndTheSecondFitOnlyIfThereIsOne) {
  Projection p = projection();
  const auto json = projection_json(p);
  ASSERT_EQ(std::ssize(json.at("scores_sd")), p.shape.scores.size());
  EXPECT_EQ(json.at("scores_sd").at(0), p.shape.scores[0]);
  EXPECT_EQ(json.at("representation").at("mean_mm"), p.representation.mean);
  EXPECT_EQ(json.at("fit").at("p95_mm"), p.fit.p95);
  EXPECT_EQ(json.at("fit").at("hausdorff_mm"), p.fit.hausdorff);
  EXPECT_EQ(json.at("fit").at("landmark_rms_mm"), p.shape.landmark_rms);
  EXPECT_EQ(json.at("left_out"), left_out());
  EXPECT_EQ(json.at("fit_without_left_out").at("mean_mm"), p.fit_without_left_out->mean);
  p.left_out.clear();
  p.fit_without_left_out.reset();
  EXPECT_FALSE(projection_json(p).contains("left_out"));
  EXPECT_FALSE(projection_json(p).contains("fit_without_left_out"));
}

}  // namespace
}  // namespace foramen
