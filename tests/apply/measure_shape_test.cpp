#include "foramen/apply/measure_shape.hpp"

#include <functional>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "apply/lopsided_family.hpp"
#include "foramen/core/error.hpp"

namespace foramen {
namespace {

constexpr double major_mm = 20, minor_mm = 8;

Mesh torus() { return build_mesh(testing::torus_soup(120, 60, major_mm, minor_mm)); }

MeasureDefinitions across() {
  return {{{"east", Vec3(30, 0, 0)}, {"west", Vec3(-30, 0, 0)}, {"first", 0}},
          {{"width", "east", "west"}, {"none", "east", "first"}},
          {{"all", NamedRegion::Ball{"east", 1000}}, {"half", NamedRegion::Ball{"first", 20}}}};
}

TEST(MeasureShape, GivesTheKnownMeasuresOfATorus) {
  const ShapeMeasures measures = Measurer(torus(), across())(torus());
  // A position beside the mean is projected to its surface. Landmark 0 is the outermost point.
  EXPECT_LT((measures.points[0] - Vec3(major_mm + minor_mm, 0, 0)).norm(), 1e-12);
  EXPECT_NEAR(measures.distances[0], 2 * (major_mm + minor_mm), 1e-9);
  EXPECT_NEAR(measures.distances[1], 0, 1e-12);
  EXPECT_NEAR(measures.areas[0], 4 * std::numbers::pi * std::numbers::pi * major_mm * minor_mm, 12);
  EXPECT_LT(measures.areas[1], 0.5 * measures.areas[0]);
}

TEST(MeasureShape, ARegionOfLandmarksIsTheTrianglesBetweenThem) {
  const Mesh mesh = torus();
  const auto& t = mesh.triangles()[7];
  const Measurer measurer(mesh, {{}, {}, {{"one", std::vector<int>{t[0], t[1], t[2]}}}});
  EXPECT_DOUBLE_EQ(measurer(mesh).areas.at(0), area(mesh.triangle(FaceId(7))));
}

TEST(MeasureShape, RigidMotionMovesPointsAndChangesNoMeasure) {
  const RigidTransform pose = testing::some_pose(1.1);
  const Mesh mesh = torus();
  const Measurer measurer(mesh, across());
  const ShapeMeasures here = measurer(mesh), there = measurer(transformed(mesh, pose));
  for (std::size_t i = 0; i < here.points.size(); ++i)
    EXPECT_LT((there.points[i] - pose * here.points[i]).norm(), 1e-9);
  for (std::size_t i = 0; i < here.distances.size(); ++i)
    EXPECT_NEAR(there.distances[i], here.distances[i], 1e-9);
  for (std::size_t i = 0; i < here.areas.size(); ++i) EXPECT_NEAR(there.areas[i], here.areas[i], 1e-6);
}

TEST(MeasureShape, AreDefinedOnTheMeanAndFollowTheLandmarks) {
  const Mesh mean = torus();
  std::vector<Vec3> doubled(mean.positions().begin(), mean.positions().end());
  for (Vec3& p : doubled) p *= 2;
  const Measurer measurer(mean, across());
  const ShapeMeasures before = measurer(mean), after = measurer(mean.with_positions(doubled));
  EXPECT_NEAR(after.distances[0], 2 * before.distances[0], 1e-9);
  EXPECT_NEAR(after.areas[1], 4 * before.areas[1], 1e-6);
}

TEST(MeasureShape, LandmarksAloneGiveTheSame) {
  const Mesh mesh = torus();
  const Measurer measurer(mesh, across());
  const ShapeMeasures of_mesh = measurer(mesh), of_landmarks = measurer(mesh.positions());
  EXPECT_EQ(of_landmarks.points, of_mesh.points);
  EXPECT_EQ(of_landmarks.distances, of_mesh.distances);
  EXPECT_EQ(of_landmarks.areas, of_mesh.areas);
  EXPECT_THROW(measurer(mesh.positions().first(7)), InvalidInput);
}

TEST(MeasureShape, NamesWhatItRefuses) {
  const auto refused = [](const std::function<void(MeasureDefinitions&)>& spoil, const std::string& said) {
    MeasureDefinitions definitions = across();
    spoil(definitions);
    try {
      const Measurer measurer(torus(), definitions);
      FAIL() << said;
    } catch (const InvalidInput& e) {
      EXPECT_THAT(e.what(), ::testing::HasSubstr(said));
    }
  };
  refused([](auto& d) { d.points[1].name = "east"; }, "\"east\": is defined twice");
  refused([](auto& d) { d.points[2].place = 7200; }, "\"first\": landmark 7200");
  refused([](auto& d) { d.distances[0].to = "north"; }, "\"width\": there is no point \"north\"");
  refused([](auto& d) { d.regions[1].extent = NamedRegion::Ball{"first", 0.01}; }, "\"half\": holds no");
  refused([](auto& d) { d.regions[1].extent = NamedRegion::Ball{"first", -1}; }, "\"half\": its radius");
  refused([](auto& d) { d.regions[0].extent = std::vector<int>{0, -1}; }, "\"all\": landmark -1");
  const Measurer measurer(torus(), across());
  EXPECT_THROW(measurer(build_mesh(testing::torus_soup(20, 10))), InvalidInput);
}

}  // namespace
}  // namespace foramen
