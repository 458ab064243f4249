#include "foramen/evaluate/region_transfer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "foramen/core/error.hpp"
#include "support/messages.hpp"
#include "support/torus_cohort.hpp"

namespace foramen {
namespace {

constexpr int slice_count = 20, in_slice = 8;

/// Deformed tori whose surfaces are their corresponding meshes.
CorrespondingCohort cohort_of(int shapes) {
  CorrespondingCohort cohort = testing::torus_cohort({.shapes = shapes, .shapes_per_subject = 1});
  for (int s = 0; s < shapes; ++s) cohort.inputs[s] = corresponding_mesh(cohort, s);
  return cohort;
}

/// The region "slice" of these slices along the torus; all other vertices are in no region.
RegionsOfShape slices(int first, int count) {
  RegionsOfShape regions{{"slice"}, std::vector<int>(slice_count * in_slice, -1)};
  for (int i = first; i < first + count; ++i)
    for (int j = 0; j < in_slice; ++j) regions.of_vertex[i * in_slice + j] = 0;
  return regions;
}

double area_of(const CorrespondingCohort& cohort, int shape, int first, int count) {
  const auto areas = vertex_areas(corresponding_mesh(cohort, shape));
  double sum = 0;
  for (int v = first * in_slice; v < (first + count) * in_slice; ++v) sum += areas[VertexId(v)];
  return sum;
}

TEST(RegionTransfer, EqualRegionsOverlapWhollyAndDistantOnesNotAtAll) {
  const CorrespondingCohort cohort = cohort_of(3);
  const RegionTransfer t = region_transfer(cohort, {slices(2, 4), slices(2, 4), slices(9, 4)}, RunContext(2));
  EXPECT_EQ(t.labelled_shapes, 3);
  ASSERT_EQ(t.pairs.size(), 6u);
  for (const RegionPair& pair : t.pairs)
    EXPECT_DOUBLE_EQ(pair.dice, pair.from == 2 || pair.to == 2 ? 0.0 : 1.0);
  EXPECT_NEAR(t.dice.mean, 1.0 / 3, 1e-15);
}

TEST(RegionTransfer, AVertexWeighsByTheMeanOfItsAreasOnBothShapes) {
  const CorrespondingCohort cohort = cohort_of(3);
  const RegionTransfer t = region_transfer(cohort, {slices(0, 4), slices(1, 5), {}}, RunContext(1));
  const auto weight = [&](int first, int count) {
    return (area_of(cohort, 0, first, count) + area_of(cohort, 1, first, count)) / 2;
  };
  const double expected = 2 * weight(1, 3) / (weight(0, 4) + weight(1, 5));
  ASSERT_EQ(t.pairs.size(), 2u);
  for (const RegionPair& pair : t.pairs) EXPECT_NEAR(pair.dice, expected, 1e-12);
  EXPECT_EQ(t.labelled_shapes, 2);
}

TEST(RegionTransfer, AVertexHasTheLabelOfTheNearestVertexOfTheInput) {
  CorrespondingCohort cohort = cohort_of(3);
  cohort.inputs[1] = build_mesh(testing::renumbered(cohort.inputs[1].soup(), 5));
  RegionsOfShape renumbered{{"slice"}, {}};
  const RegionsOfShape plain = slices(3, 6);
  for (const Vec3& p : cohort.inputs[1].positions()) {
    std::size_t nearest = 0;
    for (std::size_t v = 0; v < cohort.corresponding[1].size(); ++v)
      if ((cohort.corresponding[1][v] - p).norm() < (cohort.corresponding[1][nearest] - p).norm())
        nearest = v;
    renumbered.of_vertex.push_back(plain.of_vertex[nearest]);
  }
  EXPECT_DOUBLE_EQ(region_transfer(cohort, {plain, renumbered, plain}, RunContext(1)).dice.mean, 1);
}

TEST(RegionTransfer, RegionsAreMatchedByNameAndCountWhereBothShapesHaveThem) {
  const CorrespondingCohort cohort = cohort_of(3);
  RegionsOfShape both = slices(0, 3), other_order = slices(6, 2);
  both.names = {"10", "9"};
  for (int j = 0; j < in_slice; ++j) both.of_vertex[7 * in_slice + j] = 1;
  other_order.names = {"9"};
  const RegionTransfer t = region_transfer(cohort, {both, both, other_order}, RunContext(1));
  ASSERT_EQ(t.by_region.size(), 2u);
  EXPECT_EQ(t.by_region[0].region, "9");  // whole numbers are in their order
  EXPECT_EQ(t.by_region[0].dice.pairs, 6);
  EXPECT_EQ(t.by_region[1].region, "10");
  EXPECT_EQ(t.by_region[1].dice.pairs, 2);
  EXPECT_DOUBLE_EQ(t.by_region[1].dice.mean, 1);
  EXPECT_DOUBLE_EQ(t.dice.mean, (t.by_region[0].dice.mean + 1) / 2);
}

TEST(RegionTransfer, LabelsOfAnotherSurfaceAreRefused) {
  const CorrespondingCohort cohort = cohort_of(3);
  RegionsOfShape shorter = slices(0, 3);
  shorter.of_vertex.pop_back();
  EXPECT_THAT(testing::refusal([&] {
                region_transfer(cohort, {slices(0, 3), shorter, {}}, RunContext(1));
              }),
              testing::says("label 159 vertices, but its surface has 160"));
  EXPECT_THAT(testing::refusal([&] {
                region_transfer(cohort, {slices(0, 3), {}, {}}, RunContext(1));
              }),
              testing::says("no two shapes of different subjects"));
}

}  // namespace
}  // namespace foramen
