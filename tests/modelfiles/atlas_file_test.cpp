#include "modelfiles/atlas_file.hpp"

#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/meshes.hpp"
#include "support/temporary_folder.hpp"

namespace foramen {
namespace {

using ::testing::HasSubstr;

// A torus with loops along both of its angles. Its map does not matter here.
Atlas torus_atlas() {
  constexpr int around = 8, tube = 6;
  Atlas atlas;
  atlas.surface = build_mesh(testing::torus_soup(around, tube));
  atlas.map.turns = VertexMap<Vec2>(atlas.surface.vertex_count(), Vec2(0.25, 0.5));
  atlas.map.jumps = HalfedgeMap<Vec2i>(atlas.surface.halfedge_count(), Vec2i(1, -2));
  for (int i = 0; i < around; ++i) atlas.loops[0].emplace_back(i * tube);
  for (int j = 0; j < tube; ++j) atlas.loops[1].emplace_back(j);
  atlas.landmarks.turns = {Vec2(0.1, 0.2), Vec2(0.3, 0.4), Vec2(0.5, 0.6)};
  atlas.landmarks.triangles = {{0, 1, 2}};
  atlas.landmarks.jumps = HalfedgeMap<Vec2i>(3, Vec2i::Zero());
  atlas.curvatures = {Vec2(0.5, -0.25), Vec2(0, 0), Vec2(0.125, 1)};
  atlas.names = {"a"};
  atlas.transforms = {Eigen::Matrix4d::Identity()};
  return atlas;
}

class AtlasFile : public ::testing::Test {
 protected:
  Atlas written_and_read(const Atlas& atlas) const {
    write_atlas(folder_.path() / "atlas.h5", atlas);
    return read_atlas(folder_.path() / "atlas.h5");
  }
  void expect_refused(const Atlas& atlas, const std::string& why) const {
    try {
      written_and_read(atlas);
      ADD_FAILURE() << "not refused: " << why;
    } catch (const Error& e) {
      EXPECT_THAT(e.what(), HasSubstr(why));
      EXPECT_THAT(e.what(), HasSubstr("atlas.h5"));
    }
  }

 private:
  testing::TemporaryFolder folder_;
};

TEST_F(AtlasFile, ComesBackAsItWas) {
  const Atlas atlas = torus_atlas(), read = written_and_read(atlas);
  EXPECT_EQ(read.surface.triangles(), atlas.surface.triangles());
  EXPECT_EQ(read.map.turns, atlas.map.turns);
  EXPECT_EQ(read.map.jumps, atlas.map.jumps);
  EXPECT_EQ(read.loops, atlas.loops);
  EXPECT_EQ(read.landmarks.triangles, atlas.landmarks.triangles);
  EXPECT_EQ(read.names, atlas.names);
  EXPECT_EQ(read.curvatures, atlas.curvatures);
}

TEST_F(AtlasFile, NeedNotHaveCurvatures) {
  Atlas atlas = torus_atlas();
  atlas.curvatures.clear();
  EXPECT_TRUE(written_and_read(atlas).curvatures.empty());
}

TEST_F(AtlasFile, OneThingBrokenIsNamed) {
  Atlas jumping = torus_atlas();
  std::swap(jumping.loops[0][2], jumping.loops[0][5]);
  expect_refused(jumping, "/loops");
  Atlas open = torus_atlas();
  TriangleSoup soup = open.surface.soup();
  soup.triangles.pop_back();
  open.surface = build_mesh(std::move(soup));
  open.map.jumps = HalfedgeMap<Vec2i>(open.surface.halfedge_count(), Vec2i::Zero());
  expect_refused(open, "/template/triangles");
  Atlas short_of_turns = torus_atlas();
  short_of_turns.map.turns.values().pop_back();
  expect_refused(short_of_turns, "/template/turns");
  Atlas short_of_curvatures = torus_atlas();
  short_of_curvatures.curvatures.pop_back();
  expect_refused(short_of_curvatures, "/landmarks/curvatures");
}

}  // namespace
}  // namespace foramen
