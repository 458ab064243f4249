#include "findings/mark_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foramen {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Evaluation marked(const std::string& curve, double mean) {
  Evaluation e;
  e.marks =
      MarkTransfer{.points = TransferSummary{{mean, 0.25, 6}, 2.5, 12},
                   .curves = TransferSummary{{mean, {}, 6}, 1, 6},
                   .by_point = {{"tip", MarkPart::point, {mean, {}, 6}}, {curve, MarkPart::end, {1, {}, 6}}},
                   .by_curve = {{curve, {mean, {}, 6}}},
                   .pairs = {},
                   .marked_shapes = 3,
                   .incomplete_shapes = 1,
                   .off_surface_mm = {},
                   .reversed = {}};
  return e;
}

TEST(MarkTables, HaveARowForEveryMarkOfAnyModel) {
  const Evaluation a = marked("rim", 0.5), b = marked("facet", 2), none;
  const auto tables = mark_tables({{"A", &a}, {"B", &b}, {"C", &none}});
  ASSERT_EQ(tables.size(), 2u) << "there are no regions";
  EXPECT_THAT(tables[0].header, ElementsAre("curve", "A", "B", "C"));
  EXPECT_THAT(tables[0].rows,
              ElementsAre(ElementsAre("all", "0.500", "2.000", "-"), ElementsAre("rim", "0.500", "-", "-"),
                          ElementsAre("facet", "-", "2.000", "-")));
  ASSERT_EQ(tables[1].rows.size(), 4u);
  EXPECT_THAT(tables[1].rows[0], ElementsAre("all", "0.500 ± 0.250", "2.000 ± 0.250", "-"));
  EXPECT_THAT(tables[1].rows[1], ElementsAre("tip", "0.500", "2.000", "-"));
  EXPECT_THAT(tables[1].rows[2], ElementsAre("rim, end", "1.000", "-", "-"));
  EXPECT_THAT(mark_tables({{"C", &none}}), IsEmpty());
}

TEST(MarkLines, SayHowManyShapesLackMarks) {
  Evaluation e = marked("rim", 0.5);
  e.marks->curves.reset();
  e.regions = RegionTransfer{{0.875, {}, 6}, {{"1", {}}}, {}, 3};
  EXPECT_THAT(
      mark_lines(e),
      ElementsAre("marks, points: mean 0.500 ± 0.250 mm, p95 2.50 mm (12 transfers, 6 pairs of 3 shapes, of "
                  "which 1 lack some marks)",
                  "regions: mean Dice 0.8750 (1 regions, 6 pairs of 3 shapes)"));
  EXPECT_THAT(mark_lines(Evaluation()), IsEmpty());
}

}  // namespace
}  // namespace foramen
