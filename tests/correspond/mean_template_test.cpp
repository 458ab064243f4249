#include "correspond/mean_template.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "correspond/knobbly_family.hpp"
#include "foramen/core/geometry.hpp"
#include "foramen/correspond/registration_frame.hpp"
#include "foramen/correspond/registration_options.hpp"
#include "foramen/spatial/triangle_tree.hpp"
#include "sampling/lift_to_surface.hpp"
#include "sampling/torus_grid.hpp"

namespace foramen {
namespace {

TEST(RemeshedTemplate, HasItsVerticesOnTheSurfaceWhereTheirTurnsAre) {
  const testing::MappedSurface torus = testing::member_surface(1, 3000);
  const TemplateSurface coarse = remeshed_template(torus.mesh, torus.map, 500, RunContext(1));
  ASSERT_EQ(coarse.mesh.vertex_count(), 500);
  EXPECT_EQ(coarse.mesh.euler_characteristic(), 0);
  EXPECT_EQ(coarse.map.lattice, torus.map.lattice);
  for (const FaceId f : coarse.mesh.faces()) EXPECT_GT(signed_area(coarse.mesh, coarse.map, f), 0);
  const TriangleTree surface(torus.mesh);
  const TorusLocator locator(torus.mesh, torus.map);
  for (const VertexId v : coarse.mesh.vertices()) {
    EXPECT_LT(std::sqrt(surface.closest(coarse.mesh.position(v)).squared_distance), 1e-9);
    EXPECT_LT((position(torus.mesh, locator.locate(coarse.map.turns[v])) - coarse.mesh.position(v)).norm(),
              1e-6);
  }
}

// Points are linear in the strength. Therefore, the mean of two members is the member between them, except
// for the small rotation that alignment removes.
TEST(MeanTemplate, OfTwoMembersIsTheMemberBetweenThem) {
  const testing::MappedSurface thin = testing::member_surface(0.9, 6000),
                               thick = testing::member_surface(1.1, 6000);
  const TorusLocator a(thin.mesh, thin.map), b(thick.mesh, thick.map);
  const std::vector<const TorusLocator*> shapes{&a, &b};
  const TemplateOptions options{.vertices = 500, .grid_points = 3000};
  const MeanTemplate mean = mean_template(shapes, thin.map.lattice, RunContext(1), options);
  const TorusGrid grid = make_torus_grid(thin.map.lattice, options.grid_points);
  ASSERT_EQ(mean.grid.size(), grid.turns.size());
  const std::vector<Vec3> between = testing::on_member(grid.turns, 1);
  const SimilarityTransform motion = fit_similarity(mean.grid, between, ScaleMode::keep);
  double sum = 0;
  for (std::size_t i = 0; i < between.size(); ++i) sum += (motion(mean.grid[i]) - between[i]).squaredNorm();
  EXPECT_LT(std::sqrt(sum / static_cast<double>(between.size())), 0.05);
  ASSERT_EQ(mean.transforms.size(), 2u);
  for (const SimilarityTransform& t : mean.transforms) EXPECT_EQ(t.scale, 1) << "sizes are kept";
  EXPECT_EQ(mean.surface.mesh.vertex_count(), options.vertices);
}

TEST(MeanTemplate, ThreadsChangeNothing) {
  const testing::MappedSurface thin = testing::member_surface(0.9, 2000),
                               thick = testing::member_surface(1.1, 2000);
  const TorusLocator a(thin.mesh, thin.map), b(thick.mesh, thick.map);
  const std::vector<const TorusLocator*> shapes{&a, &b};
  const auto made = [&](int threads) {
    return mean_template(shapes, thin.map.lattice, RunContext(threads),
                         {.vertices = 200, .grid_points = 1000});
  };
  const MeanTemplate one = made(1), four = made(4);
  EXPECT_EQ(one.grid, four.grid);
  EXPECT_EQ(one.surface.map.turns, four.surface.map.turns);
  EXPECT_EQ(one.surface.mesh.triangles(), four.surface.mesh.triangles());
}

}  // namespace
}  // namespace foramen
