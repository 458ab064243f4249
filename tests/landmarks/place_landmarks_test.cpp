#include "foramen/landmarks/place_landmarks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "correspond/knobbly_family.hpp"
#include "foramen/core/error.hpp"
#include "sampling/landmark_archive.hpp"
#include "support/memory_store.hpp"

namespace foramen {
namespace {

using ::testing::ElementsAre;
using testing::MemoryStore;

// Shapes whose true maps are known take the place of a registered cohort.
struct MappedShapes {
  std::vector<Shape> shapes;
  Correspondence correspondence;
};

MappedShapes mapped_shapes(const std::vector<double>& strengths) {
  MappedShapes cohort;
  for (const double strength : strengths) {
    testing::MappedSurface member = testing::member_surface(strength, 3000);
    cohort.shapes.push_back({"strength " + std::to_string(strength), std::move(member.mesh)});
    cohort.correspondence.registration.shapes.emplace_back().name = cohort.shapes.back().name;
    cohort.correspondence.maps.push_back(std::move(member.map));
  }
  return cohort;
}

PlaceLandmarksOptions few() {
  PlaceLandmarksOptions options;
  options.count = 400;
  options.spread.grid_points = 3000;
  options.spread.density_updates = 1;
  return options;
}

TEST(PlaceLandmarks, AreWhereTheMapsHaveTheSamePlaceOfEveryShape) {
  MappedShapes cohort = mapped_shapes({0.8, 1.2});
  std::reverse(cohort.shapes.begin(), cohort.shapes.end());  // they are found by their names
  const Landmarks landmarks = place_landmarks(cohort.shapes, cohort.correspondence, few(), RunContext(2));
  EXPECT_THAT(landmarks.names, ElementsAre(cohort.shapes[1].name, cohort.shapes[0].name));
  EXPECT_EQ(landmarks.remaining_flips, 0);
  EXPECT_EQ(std::ssize(landmarks.mesh.turns), few().count + landmarks.inserted);
  for (const int i : {0, 1}) {
    const std::vector<Vec3> truth = testing::on_member(landmarks.mesh.turns, i == 0 ? 0.8 : 1.2);
    ASSERT_EQ(landmarks.points[i].size(), truth.size());
    // The shape's chords lie within its curved surface, at most the square of an edge over eight radii.
    for (std::size_t k = 0; k < truth.size(); ++k)
      EXPECT_LT((landmarks.points[i][k] - truth[k]).norm(), 0.35);
  }
}

TEST(PlaceLandmarks, AMissingShapeIsNamed) {
  MappedShapes cohort = mapped_shapes({0.8, 1.2});
  cohort.shapes.pop_back();
  EXPECT_THROW(place_landmarks(cohort.shapes, cohort.correspondence, few(), RunContext(1)), InvalidInput);
}

std::string bytes_of(const Landmarks& landmarks) {
  return to_bytes(landmarks.points) + to_bytes(landmarks.mesh);
}

TEST(PlaceLandmarks, AreTakenUpWhereTheSameShapesHaveThemAlready) {
  const MappedShapes cohort = mapped_shapes({0.8, 1.2, 1});
  const auto store = std::make_shared<MemoryStore>();
  int chosen = 0;
  const RunContext ctx = RunContext(1, [&](const Progress& progress) {
                           chosen += progress.stage == "resample" && progress.fraction == 0.3;
                         }).with_store(store);
  const auto placed = [&](const MappedShapes& shapes, const PlaceLandmarksOptions& options) {
    return place_landmarks(shapes.shapes, shapes.correspondence, options, ctx);
  };
  const std::string first = bytes_of(placed(cohort, few()));
  EXPECT_EQ(first, bytes_of(place_landmarks(cohort.shapes, cohort.correspondence, few(), RunContext(1))));
  EXPECT_EQ(bytes_of(placed(cohort, few())), first);
  EXPECT_EQ(chosen, 1);
  EXPECT_EQ(store->size(), 1);
  PlaceLandmarksOptions others = few();
  others.spread.density_updates = 0;
  EXPECT_NE(bytes_of(placed(cohort, others)), first);
  EXPECT_NE(bytes_of(placed(mapped_shapes({0.8, 1.2}), few())), first);
  EXPECT_EQ(chosen, 3);
}

TEST(LandmarkArchive, RefinedLandmarksComeBackWhole) {
  RefinedLandmarks refined;
  refined.landmarks = {{Vec2(0.25, 0.5), Vec2(1, 2)},
                       {{1, 2, 3}},
                       HalfedgeMap<Vec2i>(std::vector<Vec2i>{Vec2i(1, -1), Vec2i(0, 2), Vec2i(-1, -1)})};
  refined.inserted = 1;
  refined.flips = 2;
  refined.moved = 3;
  refined.initial = 4;
  refined.remaining = 5;
  refined.initial_self_intersections = 6;
  refined.remaining_self_intersections = 7;
  const std::string bytes = to_bytes(refined);
  const auto again = from_bytes<RefinedLandmarks>(bytes);
  EXPECT_EQ(to_bytes(again), bytes);
  EXPECT_EQ(again.landmarks.turns, refined.landmarks.turns);
  EXPECT_EQ(again.landmarks.triangles, refined.landmarks.triangles);
  EXPECT_EQ(again.landmarks.jumps, refined.landmarks.jumps);
  EXPECT_THAT((std::vector<int>{again.inserted, again.flips, again.moved, again.initial, again.remaining,
                                again.initial_self_intersections, again.remaining_self_intersections}),
              ElementsAre(1, 2, 3, 4, 5, 6, 7));
}

}  // namespace
}  // namespace foramen
