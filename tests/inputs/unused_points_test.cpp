#include "inputs/unused_points.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/units.hpp"
#include "foramen/io/mesh_file.hpp"
#include "inputs/read_cohort.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;
using testing::torus_soup;

TEST(UnusedPoints, AreDroppedAndTheOthersKeepTheirOrder) {
  const TriangleSoup torus = torus_soup(10, 8);
  TriangleSoup with = torus;
  with.points.insert(with.points.begin() + 5, Vec3(1, 2, 3));
  with.points.emplace_back(500, 0, 0);
  for (auto& triangle : with.triangles)
    for (int& corner : triangle) corner += corner >= 5 ? 1 : 0;
  const auto note = drop_unused_points(with);
  ASSERT_TRUE(note);
  EXPECT_THAT(note->text, HasSubstr("2 points belong to no triangle"));
  EXPECT_EQ(with.points, torus.points);
  EXPECT_EQ(with.triangles, torus.triangles);
  EXPECT_FALSE(drop_unused_points(with));
}

TEST(UnusedPoints, OfASurfaceThatIsNoneStayForTheAudit) {
  TriangleSoup damaged = torus_soup(10, 8);
  damaged.points.emplace_back(0, 0, 0);
  damaged.triangles[3][1] = 99;
  const TriangleSoup before = damaged;
  EXPECT_FALSE(drop_unused_points(damaged));
  EXPECT_EQ(damaged.points, before.points);
  TriangleSoup points_only{before.points, {}};
  EXPECT_FALSE(drop_unused_points(points_only));
  EXPECT_EQ(points_only.points, before.points);
}

TEST(ReadShape, UnusedPointsAreNoObstacleAndAreSaid) {
  const testing::TemporaryFolder folder;
  TriangleSoup soup = torus_soup(24, 12);
  soup.points.emplace_back(5000, 0, 0);  // far away, so that the size would be refused with it
  const auto file = folder.file("stray.ply");
  write_ply(file, soup);
  const InputShape shape = read_shape(file, InputUnit(), std::nullopt, RunContext(1));
  EXPECT_EQ(shape.mesh.vertex_count(), 24 * 12);
  ASSERT_EQ(shape.notes.size(), 1u);
  EXPECT_THAT(shape.notes[0].text, HasSubstr("stray.ply"));
}

}  // namespace
}  // namespace foramen
