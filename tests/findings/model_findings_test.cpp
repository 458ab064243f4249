#include "findings/model_findings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace foramen {
namespace {

using ::testing::EndsWith;
using ::testing::StartsWith;

// Measures are computed only for some numbers of modes.
TEST(SummaryLines, CountTheModesOfTheModelNotTheNumbersOfModesMeasured) {
  constexpr int shapes = 200;
  RunRecord run{.reference = "a7", .landmarks_inserted = 3, .landmark_triangles = 8};
  Evaluation evaluation;
  evaluation.landmarks = 4;
  for (int i = 0; i < shapes; ++i) {
    run.shapes.push_back({.used = UsedShape{.flips_in_map = 0}});
    evaluation.names.push_back("a" + std::to_string(i));
  }
  evaluation.representation.shapes.resize(shapes);
  for (const int modes : mode_counts(shapes - 1)) evaluation.compactness.push_back({modes, 1.0, 1.0});
  const auto lines = summary_lines(run, evaluation);
  ASSERT_FALSE(lines.empty());
  EXPECT_THAT(lines[0], StartsWith("200 of 200 shapes used, reference a7, 4 landmarks (3 inserted"));
  EXPECT_THAT(lines[0], EndsWith(", 199 modes"));
}

}  // namespace
}  // namespace foramen
