#include "foramen/core/marks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foramen {
namespace {

using ::testing::ElementsAre;

TEST(RegionsOfLabels, AreNamedByTheirLabelsAndZeroIsNone) {
  const std::vector<int> labels{7, 0, 2, 7, -1};
  const RegionsOfShape regions = regions_of_labels(labels);
  EXPECT_THAT(regions.names, ElementsAre("7", "2"));
  EXPECT_THAT(regions.of_vertex, ElementsAre(0, -1, 1, 0, -1));
}

}  // namespace
}  // namespace foramen
