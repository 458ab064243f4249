// What shapes make together comes back whole, and leads to the same next step.
#include "correspond/template_archive.hpp"
#include "correspond/cohort_prior.hpp"
#include "correspond/mean_template.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "sampling/lift_to_surface.hpp"

#include <gtest/gtest.h>

#include "correspond/knobbly_family.hpp"
#include "correspond/member_steps.hpp"

namespace foramen {
namespace {

template <class Value>
Value there_and_back(const Value& value) {
  const std::string bytes = to_bytes(value);
  Value again = from_bytes<Value>(bytes);
  EXPECT_EQ(to_bytes(again), bytes);
  return again;
}

MeanTemplate some_mean() {
  const testing::MappedSurface thin = testing::member_surface(0.9, 2000),
                               thick = testing::member_surface(1.1, 2000);
  const TorusLocator a(thin.mesh, thin.map), b(thick.mesh, thick.map);
  const std::vector<const TorusLocator*> shapes{&a, &b};
  return mean_template(shapes, thin.map.lattice, RunContext(1), {.vertices = 200, .grid_points = 1000});
}

TEST(TemplateArchive, AMeanComesBack) {
  MeanTemplate mean = some_mean();
  mean.surface.curvatures = VertexMap<Vec2>(mean.surface.mesh.vertex_count(), Vec2(0.5, -0.25));
  const MeanTemplate again = there_and_back(mean);
  EXPECT_EQ(again.surface.mesh.soup().points, mean.surface.mesh.soup().points);
  EXPECT_EQ(again.surface.mesh.triangles(), mean.surface.mesh.triangles());
  EXPECT_EQ(again.surface.map.lattice, mean.surface.map.lattice);
  EXPECT_EQ(again.surface.map.turns, mean.surface.map.turns);
  EXPECT_EQ(again.surface.map.jumps, mean.surface.map.jumps);
  EXPECT_EQ(again.surface.curvatures, mean.surface.curvatures);
  EXPECT_EQ(again.grid, mean.grid);
  ASSERT_EQ(again.transforms.size(), mean.transforms.size());
  for (std::size_t i = 0; i < mean.transforms.size(); ++i) {
    EXPECT_EQ(again.transforms[i].scale, mean.transforms[i].scale);
    EXPECT_EQ(again.transforms[i].rotation, mean.transforms[i].rotation);
    EXPECT_EQ(again.transforms[i].translation, mean.transforms[i].translation);
  }
}

TEST(TemplateArchive, ATemplateThatWasReadIsPreparedToTheSameBits) {
  const TemplateSurface surface = some_mean().surface;
  RegisterGroupOptions options;
  options.displacements.most_functions = 30;
  const PreparedTemplate made(surface, options), read(there_and_back(surface), options);
  EXPECT_EQ(read.displacements, made.displacements);
  EXPECT_EQ(read.metric.tensors(), made.metric.tensors());
  const testing::MappedSurface shape = testing::member_surface(1.2, 500);
  EXPECT_EQ(read.metric.at(shape.mesh, shape.map).to_target, made.metric.at(shape.mesh, shape.map).to_target);
}

TEST(TemplateArchive, PriorsComeBackToTheSamePriorOfEveryShape) {
  CohortPriors priors;
  priors.coefficients.resize(6, 4);
  for (int k = 0; k < 24; ++k) priors.coefficients(k) = std::sin(k);
  priors.unexplained_share = 0.3;
  const CohortPriors again = there_and_back(priors);
  EXPECT_EQ(again.coefficients, priors.coefficients);
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(again.of_member(i).mean, priors.of_member(i).mean);
    EXPECT_EQ(again.of_member(i).directions, priors.of_member(i).directions);
    EXPECT_EQ(again.of_member(i).variance, 0.3);
  }
  EXPECT_EQ(there_and_back(CohortPriors()).coefficients.size(), 0) << "of fewer than 3 shapes";
}

}  // namespace
}  // namespace foramen
